// Threads that read sensors, the camera and the radio, show and drive, each at times of its own;
// all that they saw is printed in the order in which they did. What they count is thread_local: of
// several robots each has a process of its own.
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <thread>
#include <vector>

#include <eyebot++.h>

namespace {

thread_local volatile int readings = 0;
char text[1 << 16];  // without a lock: one at a time
std::size_t used = 0;

[[gnu::format(printf, 1, 2)]] void tell(const char* format, ...) {
  va_list values;
  va_start(values, format);
  used += static_cast<std::size_t>(std::vsnprintf(text + used, sizeof text - used, format, values));
  va_end(values);
}

void sense(char name, int pause) {
  for (int i = 0; i < 12; ++i) {
    int x = 0;
    int y = 0;
    int phi = 0;
    VWGetPosition(&x, &y, &phi);
    const int psd = PSDGet(1 + name % 3);
    readings = readings + psd;
    tell("%c%d:%d,%d,%d ", name, OSGetCount(), x, phi, psd);
    if (pause > 0) OSWait(pause);
  }
}

void drive() {
  std::srand(static_cast<unsigned>(std::time(nullptr)));
  for (int i = 0; i < 12; ++i) {
    VWSetSpeed(std::rand() % 300, std::rand() % 60 - 30);
    LCDSetPrintf(1, 1, "%d", i);
    tell("d%d:%d ", OSGetCount(), PSDGet(PSD_FRONT));
    OSWait(3);
  }
}

// Two of them wait for the same camera.
void look(char name) {
  static BYTE images[2][QQVGA_SIZE];
  BYTE* const image = images[name == 'l'];
  if (CAMWIDTH == 0) CAMInit(QQVGA);
  for (int i = 0; i < 3; ++i) {
    CAMGet(image);
    unsigned sum = 0;
    for (int j = 0; j < QQVGA_SIZE; ++j) sum = 31 * sum + image[j];
    tell("%c%d:%u ", name, OSGetCount(), sum);
  }
}

void talk() {
  RADIOInit();
  for (int i = 0; i < 12; ++i) {
    int ids[256];
    char message[16];
    std::snprintf(message, sizeof message, "%d", i);
    RADIOSend(3 - OSMachineID(), message);
    tell("r%d:%d ", OSGetCount(), RADIOStatus(ids));
    OSWait(7);
    if (RADIOCheck() == 0) continue;
    int from = 0;
    RADIOReceive(&from, message, sizeof message);
    tell("R%d:%d,%s ", OSGetCount(), from, message);
  }
}

}  // namespace

// No call before the threads': the first one of theirs begins the robot's life.
int main() {
  std::vector<std::thread> threads;
  threads.emplace_back(look, 'l');
  threads.emplace_back(look, 'm');
  threads.emplace_back(talk);
  threads.emplace_back(drive);
  threads.emplace_back(sense, 'a', 3);
  threads.emplace_back(sense, 'b', 0);
  for (std::thread& thread : threads) thread.join();
  std::printf("%d: %sat %d\n", OSMachineID(), text, OSGetCount());
}
