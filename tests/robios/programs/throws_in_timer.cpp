// A timer's function throws what nobody can catch.
#include <cstdio>
#include <stdexcept>

#include "eyebot.h"

namespace {
void tick() { throw std::runtime_error("of a timer"); }
}  // namespace

int main() {
  OSAttachTimer(100, tick);
  OSWait(500);
  std::puts("went on");
  return 0;
}
