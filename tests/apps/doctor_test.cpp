// `eyebridge doctor` on machines that are made up.
#include <filesystem>

#include <gmock/gmock.h>

#include "command.hpp"
#include "fake_machine.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using testing::FakeMachine;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_command;

const std::string kPlugins = "/opt/" EYEBRIDGE_LIBDIR "/eyebridge";

ProgramRun doctor_of(const FakeMachine& machine) {
  return run_command({"doctor", "--root", machine.root()}, ".");
}

TEST(DoctorDevices, AMachineWithoutDevicesIsToldSo) {
  const FakeMachine machine;
  const ProgramRun r = doctor_of(machine);
  EXPECT_THAT(r.out,
              AllOf(ContainsRegex("serial boards +none"), ContainsRegex("udev rule +none"),
                    ContainsRegex("CAN interfaces +none"), ContainsRegex("V4L2 cameras +none"),
                    ContainsRegex("real-time +(ok +real-time priority 1|none +(nice|ordinary))")));
}

TEST(DoctorDevices, EverythingAboutABoardIsSaid) {
  const FakeMachine machine;
  machine.add_acm();
  machine.add_process(400, "ModemManager");
  machine.add_process(812, "minicom", "/dev/ttyACM0");
  machine.add_can("can0", true);
  machine.add_video(0, "Webcam C525", ":capture:", "usb-Maker_C525-video-index0");
  machine.add_video(1, "Webcam C525", ":");
  machine.add_process(900, "cheese", "/dev/video0");
  machine.file("/etc/udev/rules.d/60-eyebridge.rules", "");
  const ProgramRun r = doctor_of(machine);
  EXPECT_THAT(r.out,
              AllOf(ContainsRegex("serial boards +ok +/dev/ttyACM0"),
                    ContainsRegex("ttyACM0 +ok +Interface Board \\(03eb:2404\\), driver cdc_acm"),
                    HasSubstr("in use by minicom (process 812)"),
                    HasSubstr("ModemManager (process 400) sends modem commands"),
                    HasSubstr("eyebridge probe /dev/ttyACM0"),
                    ContainsRegex("udev rule +ok +/etc/udev/rules.d/60-eyebridge.rules"),
                    ContainsRegex("CAN interfaces +ok +can0"),
                    ContainsRegex("V4L2 cameras +ok +/dev/video0"),
                    ContainsRegex("video0 +ok +Webcam C525, camera"),
                    HasSubstr("v4l2:usb-Maker_C525-video-index0"),
                    HasSubstr("in use by cheese (process 900)"),
                    ContainsRegex("video1 +none +Webcam C525, metadata of a camera, no pictures")));
}

TEST(DoctorSanitizers, SaysWhetherTheyCanStart) {
  const FakeMachine machine;
  EXPECT_THAT(doctor_of(machine).out,
              ContainsRegex("sanitizers +none +this kernel has no vm.mmap_rnd_bits"));
  machine.file("/proc/sys/vm/mmap_rnd_bits", "32\n");
  EXPECT_THAT(doctor_of(machine).out,
              ContainsRegex("sanitizers +none +vm.mmap_rnd_bits is 32, expected at most 28: .*\n"
                            " +sudo sysctl vm.mmap_rnd_bits=28\n"));
  machine.file("/proc/sys/vm/mmap_rnd_bits", "28\n");
  EXPECT_THAT(doctor_of(machine).out, ContainsRegex("sanitizers +ok +vm.mmap_rnd_bits is 28"));
}

/// The command alone, as if it were installed without anything else.
class DoctorAlone : public ::testing::Test {
 protected:
  DoctorAlone() {
    namespace fs = std::filesystem;
    machine_.file("/opt/share/eyebridge/worlds/README.md", "");
    fs::create_directories(machine_.path("/opt/bin"));
    fs::copy_file(EYEBRIDGE_BIN "/eyebridge", machine_.path("/opt/bin/eyebridge"));
  }
  ProgramRun doctor(std::map<std::string, std::string> environment = {}) const {
    environment.emplace("DISPLAY", "");
    environment.emplace("WAYLAND_DISPLAY", "");
    environment.emplace("XDG_CACHE_HOME", machine_.path("/cache"));
    return testing::run_program(
        {{machine_.path("/opt/bin/eyebridge"), "doctor", "--root", machine_.root()},
         environment,
         machine_.root()});
  }
  void add_script(const std::string& name, const std::string& text) const {
    machine_.file(name, "#!/bin/sh\n" + text);
    std::filesystem::permissions(machine_.path(name), std::filesystem::perms::owner_all);
  }

  const FakeMachine machine_;
};

TEST_F(DoctorAlone, EachMissingPartHasOneCommandThatBringsIt) {
  const ProgramRun r = doctor();
  EXPECT_EQ(r.exit_code, 1) << "no library";
  EXPECT_THAT(r.out, AllOf(ContainsRegex("windows +none .*\n +apt install eyebridge-gui\n"),
                           ContainsRegex("import eyebridge +none .*\n +apt install "
                                         "python3-eyebridge\n"),
                           ContainsRegex("MPI +none .*\n +apt install --reinstall eyebridge\n")));
}

TEST_F(DoctorAlone, WindowsThatCannotBeLoadedSayWhy) {
  machine_.file(kPlugins + "/libeyebridge_gui.so", "not a library");
  EXPECT_THAT(doctor().out, ContainsRegex("windows +none .*libeyebridge_gui.so: .*\n +apt install "
                                          "--reinstall eyebridge-gui\n"));
}

TEST_F(DoctorAlone, APythonThatCannotImportTheModuleIsQuoted) {
  machine_.file(kPlugins + "/python/eyebridge/_core.so", "");
  machine_.file(kPlugins + "/python/eye/__main__.py", "");
  add_script("/bin/python3",
             "echo Traceback; echo \"ImportError: No module named 'numpy'\" >&2; exit 1");
  const std::map<std::string, std::string> own = {
      {"VIRTUAL_ENV", "/venv"}, {"PATH", machine_.path("/bin") + ":/usr/bin:/bin"}};
  EXPECT_THAT(doctor(own).out,
              ContainsRegex("import eyebridge +none +python3: ImportError: No module named "
                            "'numpy'\n +apt install python3-numpy\n"));
  add_script("/bin/python3", "echo \"$PYTHONPATH\"");
  EXPECT_THAT(doctor(own).out, ContainsRegex("import eyebridge +ok +python3: " +
                                             machine_.path(kPlugins + "/python")));
}

#ifdef __x86_64__
TEST_F(DoctorAlone, TheLabIsThereOnceItsKernelIsBuilt) {
  const std::string lab = "/opt/share/eyebridge/lab/";
  machine_.file(lab + "place.sh",
                "cache=$XDG_CACHE_HOME/eyebridge\nkernel_hash() { echo abc; }\n"
                "init_name() { echo init; }\nhas_room() { [ ! -e \"$1/small\" ]; }\n");
  EXPECT_THAT(doctor().out,
              ContainsRegex("lab +none .*\n +" + machine_.path(lab + "build") + "\n"));
  add_script("/cache/eyebridge/lab-abc-6.1/linux", "");
  add_script("/cache/eyebridge/lab-abc-6.1/init", "");
  EXPECT_THAT(doctor().out,
              ContainsRegex("lab +ok +" + machine_.path("/cache/eyebridge/lab-abc-6.1/linux")));
  machine_.file("/cache/eyebridge/lab-abc-6.1/small", "");
  EXPECT_THAT(doctor().out, ContainsRegex("lab +none"));
}
#endif

TEST(DoctorDevices, ARootThatIsNoFolderIsBadInput) {
  const ProgramRun r = run_command({"doctor", "--root", "/no/such/folder"}, ".");
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("--root: found /no/such/folder, expected a folder"));
}

TEST(CameraList, TellsTheCamerasAndFailsWithoutOne) {
  const FakeMachine machine;
  ProgramRun r = run_command({"camera", "list", "--root", machine.root()}, ".");
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_EQ(r.out, "Found no camera (no /dev/video*).\n");
  machine.add_video(0, "Webcam C525", ":capture:", "usb-Maker_C525-video-index0");
  r = run_command({"camera", "list", "--root", machine.root()}, ".");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, AllOf(HasSubstr("/dev/video0   Webcam C525\n"),
                           HasSubstr("--camera v4l2:usb-Maker_C525-video-index0")));
  r = run_command({"camera", "list", "--root", "/no/such/folder"}, ".");
  EXPECT_EQ(r.exit_code, 2);
}

TEST(DoctorUdev, PrintsTheRuleThatIsInstalled) {
  const ProgramRun r = run_command({"doctor", "--udev"}, ".");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, testing::file_text(EYEBRIDGE_SOURCE_DIR "/apps/udev/60-eyebridge.rules"));
  EXPECT_THAT(r.out,
              AllOf(HasSubstr("ENV{ID_MM_DEVICE_IGNORE}=\"1\""),
                    HasSubstr("ENV{ID_MM_PORT_IGNORE}=\"1\""), HasSubstr("GROUP=\"dialout\""),
                    HasSubstr("TAG+=\"uaccess\""), HasSubstr("ATTR{latency_timer}=\"1\""),
                    HasSubstr("/etc/udev/rules.d/60-eyebridge.rules")));
}

}  // namespace
}  // namespace eyebridge
