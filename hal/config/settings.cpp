#include <algorithm>
#include <array>

#include "eyebridge/base/text.hpp"
#include "eyebridge/hal/config.hpp"

namespace eyebridge::hal {
namespace {

using Kind = Setting::Kind;

constexpr Setting with_effect(Setting setting, Setting::Effect effect) {
  setting.effect = effect;
  return setting;
}

constexpr auto kSettings = std::to_array<Setting>({
    {"hal", Kind::Text, "sim", "how the robot is reached: a backend's URL"},
    {"mix", Kind::Text, "", "devices from other backends: psd=sim; drive=serial:/dev/ttyACM0"},
    {"world", Kind::Path, "", "world to drive in: .wld .maz .sim .robi .p; unset: an empty room"},
    {"cell", Kind::Text, "", "size of the maze's cells: 180mm; unset: as its file says"},
    {"robot", Kind::Text, "S4", "type of the robot where the world places none"},
    {"robots", Kind::NumberOrText, "1",
     "how many robots of the world run programs: a number, or all that it places"},
    {"shared_globals", Kind::Boolean, "false",
     "several robots of one program share its variables, as in EyeSim"},
    {"isolate", Kind::Boolean, "false",
     "each of several robots' programs has a process of its own: it crashes or hangs alone"},
    {"hdt", Kind::Path, "",
     "hardware description of a real board; unset: that of an S4. In simulation: the tables of "
     "PSDs"},
    {"psd_numbers", Kind::NumberOrText, "robot",
     "what PSD numbers mean: robot, those of its file; 2015, 1 left and 2 front instead",
     -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
     "robot|2015"},
    {"supply_voltage", Kind::Number, "7.4", "of a simulated robot's battery, volts", 0.0, 20.0},
    {"serial", Kind::Text, "", "devices of serial interfaces: 0=/dev/ttyUSB0; 1=GPS"},
    with_effect(
        {"player", Kind::Text, "auto", "plays sounds: auto, none, or a command that takes a file"},
        Setting::Effect::Starts),
    {"radio", Kind::Text, "world",
     "who can be reached: world, none, udp:239.192.7.1:7007?id=2&loss=10%&delay=20ms"},
    {"camera", Kind::Text, "render", "where frames come from: a source's URL, or none"},
    {"drive", Kind::Text, "",
     "hand or hand:free: a person with the camera drives; unset: the robot"},
    {"errors", Kind::Text, "",
     "what is wrong with simulated devices: perfect, realistic, harsh; psd:1 dropout=5%; unset: "
     "what the files say"},
    {"error_scale", Kind::Number, "100", "how much of these errors is simulated, percent", 0.0,
     100.0},
    {"faults", Kind::Text, "", "devices that fail: psd:1 lose @2s..4s; all delay 20ms"},
    {"fast", Kind::Boolean, "false", "virtual time: run as fast as the machine can"},
    {"factor", Kind::Number, "1", "simulated seconds per second of real time", 0.001, 1e6},
    {"seed", Kind::Integer, "1", "of all noise", 0},
    {"step", Kind::Duration, "10ms", "of the simulation", 0.0001, 1.0},
    {"time_limit", Kind::Duration, "", "the run ends after this long on the robot's clock"},
    {"hang_limit", Kind::Duration, "60s",
     "a program that computes this long without a call is ended, and one of several that waits so "
     "long (virtual time)",
     0.1, 1e6},
    {"stall_timeout", Kind::Duration, "2s", "a movement stalled this long has failed"},
    {"strict", Kind::Boolean, "false",
     "a mistake in a world's files ends the run; else what a line breaks is a warning"},
    {"contact", Kind::Text, "slide",
     "what a robot does that touches something: slide along it, or stop, as in 2001",
     -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
     "slide|stop"},
    {"missing_devices", Kind::Text, "warn",
     "a call for a device that the robot does not have: warn gives its failure value and says so "
     "once, error ends the program",
     -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
     "error|warn"},
    {"cost_scale", Kind::Number, "1", "factor on the time that API calls cost", 0.0, 1000.0},
    {"keys", Kind::Text, "",
     "key presses and touches: KEY1@2s,IRTV_5@12s,120:80@3s, of robot 2 alone 2:KEY1@2s; unset: "
     "the "
     "terminal"},
    {"lcd", Kind::Size, "560x400", "size of the LCD, pixels", 160, 4096},
    {"panel", Kind::Text, "auto", "where the LCD is shown: in the terminal, or nowhere",
     -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
     "auto|term|none"},
    {"gui", Kind::Text, "auto", "windows: on, off, or where there is a display and no --fast",
     -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
     "auto|on|off"},
    with_effect({"out", Kind::Path, "", "folder for pictures and trace; unset: none are written"},
                Setting::Effect::Writes),
    with_effect({"report", Kind::Path, "",
                 "file for what came of a simulated run: time, way, collisions, end, hash"},
                Setting::Effect::Writes),
    {"id_as_ascii", Kind::Boolean, "false", "classic OSMachineID() gives '1', '2' instead of 1, 2"},
    with_effect(
        {"record", Kind::Path, "", "file (.ebrec) for all exchanges with the devices, and frames"},
        Setting::Effect::Writes),
    {"record_frames", Kind::Text, "lossless", "how camera frames are kept in --record",
     -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
     "lossless|mjpeg|none"},
    {"save_frames", Kind::Integer, "20", "how many camera frames are kept in --out", 0, 1e6},
    {"log", Kind::Text, "warning", "least severity of the messages that are shown",
     -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
     "debug|info|warning|error"},
});

}  // namespace

std::span<const Setting> settings() { return kSettings; }

const Setting* find_setting(std::string_view key) {
  const auto* found = std::ranges::find(kSettings, key, &Setting::key);
  return found == kSettings.end() ? nullptr : found;
}

std::string_view nearest_key(std::string_view key) {
  // A key is short: what follows its first letters cannot make another one nearer.
  const std::string_view head = key.substr(0, 64);
  return std::ranges::min_element(
             kSettings, {},
             [&](const Setting& setting) { return edit_distance(head, setting.key); })
      ->key;
}

}  // namespace eyebridge::hal
