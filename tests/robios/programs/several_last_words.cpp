// Several robots whose programs have something to do at their end.
#include <cstdio>
#include <cstdlib>

#include <eyebot++.h>

namespace {

void say(const char* what) { std::printf("%d %s\n", OSMachineID(), what); }

struct Motors {
  ~Motors() {
    OSWait(10);
    say(VWSetSpeed(0, 0) == 0 ? "stops" : "cannot stop");
  }
} motors;

struct Late {
  ~Late() { say("ends what began late"); }
};

__attribute__((destructor)) void last() { say("is done"); }

}  // namespace

int main() {
  const int id = OSMachineID();
  VWSetSpeed(100, 0);
  OSWait(1000 * id);  // each by itself
  static const Late late;
  std::atexit([] {
    say("exits");
    std::atexit([] { say("exits again"); });
    if (OSMachineID() == 2) std::exit(8);  // as glibc: the others are still called
  });
  on_exit([](int code, void* word) { say(code == 0 ? static_cast<char*>(word) : "failed"); },
          const_cast<char*>("did well"));
  if (id == 2) std::exit(9);
  if (id == 4) std::abort();
  return 0;
}
