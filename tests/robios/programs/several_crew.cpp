// Several robots whose programs have threads: they wait for each other in every way that C++ has.
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <ctime>
#include <mutex>
#include <queue>
#include <thread>

#include <semaphore.h>
#include <unistd.h>

#include <eyebot++.h>

namespace {

std::mutex mutex;
std::condition_variable changed;
std::queue<int> readings;
bool is_done = false;
std::recursive_mutex twice;
sem_t arrived;

void drive() {
  for (int i = 0; i < 10; ++i) {
    VWSetSpeed(20 * (i % 3), 0);
    OSWait(50);
  }
  sem_post(&arrived);
}

void produce() {
  for (int i = 0; i < 5; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    {
      const std::lock_guard lock(mutex);
      readings.push(PSDGet(1));
    }
    changed.notify_one();
  }
  const std::lock_guard lock(mutex);
  is_done = true;
  changed.notify_all();
}

int consume() {
  for (int taken = 0;; ++taken) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [] { return !readings.empty() || is_done; });
    if (readings.empty()) return taken;
    readings.pop();
  }
}

}  // namespace

int main() {
  const int id = OSMachineID();
  sem_init(&arrived, 0, 0);
  const auto start = std::chrono::steady_clock::now();
  std::thread driver(drive);
  std::thread producer(produce);
  const int taken = consume();
  {
    const std::lock_guard once(twice);
    const std::lock_guard again(twice);
    std::thread([] { const std::lock_guard lock(twice); }).detach();
    usleep(2000);
  }
  sem_wait(&arrived);
  producer.join();
  driver.join();
  bool is_late = false;
  {
    std::unique_lock lock(mutex);
    is_late = changed.wait_for(lock, std::chrono::milliseconds(250)) == std::cv_status::timeout;
  }
  const auto passed = std::chrono::steady_clock::now() - start;
  std::printf("%d: took %d, %s after %ld ms, %ld\n", id, taken, is_late ? "late" : "woken",
              static_cast<long>(passed / std::chrono::milliseconds(10) * 10),
              static_cast<long>(std::time(nullptr)) / 1'000'000'000);
}
