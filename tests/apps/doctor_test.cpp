// `eyebridge doctor` on machines that are made up.
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
