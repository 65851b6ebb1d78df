// The system: who the robot is, messages, variables.

#include <array>
#include <map>
#include <mutex>
#include <string>

#include <fmt/format.h>

#include "call.hpp"
#include "classic_lcd.hpp"
#include "eyebot.h"
#include "keys_wait.hpp"
#include "timers.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

constexpr int kMachineSpeed = 25'000'000;

struct Variables {
  std::mutex mutex;
  std::array<int, 4> words{};  ///< SAVEVAR1 … 4
};

/// Texts that programs keep the address of, and might write into.
struct Texts {
  explicit Texts(Session& session) {
    const auto facts = session.backend().facts_of("robot");
    if (!facts.empty() && !facts.front().name.empty()) name = facts.front().name;
  }
  std::string version = "6.5";
  std::string name = "EyeBot";
};

char* text(const robios::Call& name, std::string Texts::*which) {
  char* const text = (Session::instance().own<Texts>().*which).data();
  return call(name, text, [&](Session&) -> Result<char*> { return text; });
}

/// Word, and shift and mask of the part of it that a number of SAVEVAR… means.
struct Variable {
  std::size_t word;
  int shift;
  int mask;
};

Result<Variable> variable(int num) {
  const int word = num < 10 ? num : num / 10;
  const int part = num < 10 ? 0 : num % 10;
  if (word < 1 || word > 4 || part > 2 || (num >= 10 && part == 0)) {
    return fail(Errc::OutOfRange,
                fmt::format("there is no variable {}; expected SAVEVAR1 … SAVEVAR4b", num));
  }
  const auto index = static_cast<std::size_t>(word - 1);
  if (part == 0) return Variable{index, 0, 0xFFFF};
  return Variable{index, part == 1 ? 8 : 0, 0xFF};
}

int of_the_loader(const robios::Call& name) {
  return doing(name, 1, [](Session&) -> Result<void> {
    return fail(Errc::Unsupported, "a call of the boot loader, which is not here");
  });
}

}  // namespace

char* OSVersion(void) { return text("OSVersion", &Texts::version); }

int OSError(const char* msg, int number, BOOL deadend) {
  return call("OSError", 1, [&](Session& session) -> Result<int> {
    const char* const text = msg == nullptr ? "" : msg;
    robios::classic::lcd(session).print(fmt::format("\n{}\nError {}\n", text, number));
    if (deadend != 0) {
      session.abort_run({Errc::Unsupported, fmt::format("OSError: {} {}", text, number)});
    }
    return robios::classic::wait_for_key(session, KEY1 | KEY2 | KEY3 | KEY4).map([](int) {
      return 0;
    });
  });
}

int OSMachineType(void) {
  return call("OSMachineType", VEHICLE, [](Session&) -> Result<int> { return VEHICLE; });
}

int OSMachineSpeed(void) {
  return call("OSMachineSpeed", kMachineSpeed,
              [](Session&) -> Result<int> { return kMachineSpeed; });
}

char* OSMachineName(void) { return text("OSMachineName", &Texts::name); }

unsigned char OSMachineID(void) {
  return call("OSMachineID", static_cast<unsigned char>(0),
              [](Session& session) -> Result<unsigned char> {
                const int zero = session.config().boolean("id_as_ascii") ? '0' : 0;
                return static_cast<unsigned char>(session.backend().robot_id() + zero);
              });
}

void* HDT_FindEntry(TypeID, DeviceSemantics) {
  return call("HDT_FindEntry", static_cast<void*>(nullptr), [](Session&) -> Result<void*> {
    return fail(Errc::Unsupported, "the hardware description is for drivers only");
  });
}

int OSEnable(void) {
  return call("OSEnable", 1, [](Session& session) -> Result<int> {
    session.timers().hold(false);
    robios::classic::kernel().disable(false);
    return 0;
  });
}

int OSDisable(void) {
  return call("OSDisable", 1, [](Session& session) -> Result<int> {
    session.timers().hold(true);
    robios::classic::kernel().disable(true);
    return 0;
  });
}

int OSGetVar(int num) {
  return call("OSGetVar", -1, [&](Session& session) -> Result<int> {
    auto& variables = session.own<Variables>();
    const std::lock_guard lock(variables.mutex);
    return variable(num).map(
        [&](const Variable& v) { return (variables.words.at(v.word) >> v.shift) & v.mask; });
  });
}

int OSPutVar(int num, int value) {
  return call("OSPutVar", 1, [&](Session& session) -> Result<int> {
    auto& variables = session.own<Variables>();
    const std::lock_guard lock(variables.mutex);
    return variable(num).and_then([&](const Variable& v) -> Result<int> {
      if (value < 0 || value > v.mask) {
        return fail(Errc::OutOfRange, fmt::format("{} does not fit into 0 … {}", value, v.mask));
      }
      int& word = variables.words.at(v.word);
      word = (word & ~(v.mask << v.shift)) | value << v.shift;
      return 0;
    });
  });
}

int OSDownload(char*, int*, int, int, int) { return of_the_loader("OSDownload"); }
int OSExecute(char*) { return of_the_loader("OSExecute"); }
int USRStart(void) { return of_the_loader("USRStart"); }
int USRResident(char*, BOOL) { return of_the_loader("USRResident"); }
