#include <gmock/gmock.h>

#include "run_program.hpp"

// The guest kernel has room for all registers of the processor. One that saves more of them is
// emulated: ptrace() is replaced in the guest kernel (larger_registers.c).
namespace eyebridge::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

ProgramRun lab_with_registers(const std::string& bytes, std::vector<std::string> command) {
  command.insert(command.begin(), {EYEBRIDGE_LAB "/run", "--time-travel", "--timeout", "50", "--"});
  return run_program(
      {command,
       {{"LD_PRELOAD", EYEBRIDGE_LARGER_REGISTERS}, {"EYEBRIDGE_TEST_REGISTERS", bytes}},
       ""});
}

// Four processes take turns and handle signals: the kernel moves the registers at each turn.
TEST(LabRegisters, ProgramsRunOnAProcessorWithAmx) {
  const ProgramRun run = lab_with_registers("11008", {"/usr/bin/python3", "-c", R"(
import os, signal
x = 1.0
def step(*_):
    global x
    x = x * 1.000001 + 0.5
signal.signal(signal.SIGUSR1, step)
children = []
for i in range(4):
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        for _ in range(200):
            os.kill(os.getpid(), signal.SIGUSR1)
            os.sched_yield()
        os.write(write, repr(x).encode())
        os._exit(0)
    children.append((child, read))
for _ in range(200): step()
print(all(os.read(read, 100).decode() == repr(x) and os.waitpid(child, 0)[1] == 0 for child, read in children))
)"});
  EXPECT_EQ(run.out, "True\n") << run.err;
  EXPECT_EQ(run.exit_code, 0);
}

TEST(LabRegisters, AGuestThatDiesOfThemShowsTheLastLinesOfItsConsole) {
  const ProgramRun run = lab_with_registers("65536", {"true"});
  EXPECT_EQ(run.exit_code, 125);
  EXPECT_THAT(run.err, HasSubstr("ptrace set fp regs failed, errno = 14"));
  EXPECT_THAT(run.err, HasSubstr("Attempted to kill init! exitcode=0x0000000b"));
}

TEST(LabRegisters, AKernelWithTooLittleRoomIsRefusedBeforeItStarts) {
  const ScratchFolder cache;
  const ProgramRun copy = run_program({{"sh", "-ec", R"(
here=$1
. "$1/place.sh"
mkdir "$2/eyebridge"
cp -rs "$cache"/lab-$(kernel_hash)-* "$2/eyebridge"
for lab in "$2"/eyebridge/*; do rm "$lab/register_room"; echo 256 >"$lab/register_room"; done
)",
                                        "sh", EYEBRIDGE_LAB, cache.path()},
                                       {},
                                       ""});
  ASSERT_EQ(copy.exit_code, 0) << copy.err;
  const ProgramRun run =
      run_program({{EYEBRIDGE_LAB "/run", "--", "true"}, {{"XDG_CACHE_HOME", cache.path()}}, ""});
  EXPECT_EQ(run.exit_code, 125);
  EXPECT_THAT(run.err, StartsWith("lab: this processor saves "));
  EXPECT_THAT(run.err, HasSubstr("the guest kernel has room for 256\n"));
  EXPECT_THAT(run.err, HasSubstr(EYEBRIDGE_LAB "/build\n"));
}

}  // namespace
}  // namespace eyebridge::testing
