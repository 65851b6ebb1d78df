#include "simulated_robot.hpp"

#include <csignal>
#include <cstdio>
#include <stdexcept>

#include "eyebridge/base/units.hpp"

namespace eyebridge::testing {
namespace {

const std::string kEyebridge = EYEBRIDGE_BIN "/eyebridge";

std::string world_file(const Task& task) { return EYEBRIDGE_SOURCE_DIR "/worlds/" + task.world; }

std::vector<std::string> firmware_command(const Task& task, const std::vector<std::string>& more) {
  std::vector<std::string> words{kEyebridge,       "firmware", "--world",
                                 world_file(task), "--robot",  task.robot};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string text_after(const std::string& text, const std::string& before) {
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos) throw std::runtime_error("expected '" + before + "' in " + text);
  return text.substr(begin + before.size());
}

Course course_of(const std::string& trace) {
  Course course;
  double t = 0;
  Pose pose;
  bool first = true;
  for (std::size_t row = trace.find('\n'); row != std::string::npos;
       row = trace.find('\n', row + 1)) {
    if (std::sscanf(trace.c_str() + row + 1, "%lf,%lf,%lf,%lf", &t, &pose.x, &pose.y,
                    &pose.theta) != 4) {
      break;
    }
    if (!first) course.length += norm(pose.position() - course.end.position());
    first = false;
    course.end = pose;
  }
  return course;
}

}  // namespace

std::vector<Task> tasks() {
  std::vector<Task> all{
      {"square", {EYEBRIDGE_EXAMPLES "/square"}, "empty-room.wld"},
      {"wall follower", {EYEBRIDGE_BIN "/parity_follower"}, "corridor.wld"},
      {"maze explorer", {EYEBRIDGE_EXAMPLES "/maze_explorer"}, "maze-5.maz", "Mouse"},
  };
  const char* const moves[] = {"forwards",  "backwards",         "turn left", "turn right",
                               "curve",     "backwards, curved", "drive to",  "replaced",
                               "to a wall", "set speed"};
  for (int i = 0; i < 10; ++i) {
    all.push_back({moves[i], {EYEBRIDGE_BIN "/parity_moves", std::to_string(i)}, "empty-room.wld"});
  }
  return all;
}

Course simulated(const Task& task) {
  const ScratchFolder folder;
  const ProgramRun run = run_program({task.program,
                                      {{"EYEBRIDGE_WORLD", world_file(task)},
                                       {"EYEBRIDGE_ROBOT", task.robot},
                                       {"EYEBRIDGE_FAST", "1"},
                                       {"EYEBRIDGE_OUT", folder.path()}},
                                      folder.path()});
  if (run.exit_code != 0) throw std::runtime_error(task.name + ": " + run.err);
  return course_of(file_text(folder.path() + "/trace.csv"));
}

FirmwareProcess::FirmwareProcess(const Task& task, const std::vector<std::string>& options)
    : program_({firmware_command(task, options), {}, ""}) {
  // "robot 1: eyebridge run --hal URL PROGRAM", then one line about all.
  hal_ = text_after(program_.wait_for("Ctrl-C ends\n"), "--hal ");
  hal_ = hal_.substr(0, hal_.find(' '));
}

Pose FirmwareProcess::stop() {
  program_.finish(SIGTERM);
  const std::string place = text_after(program_.said(), "robot 1 at ");
  double x = 0;
  double y = 0;
  double degrees = 0;
  if (std::sscanf(place.c_str(), "%lf mm %lf mm %lf degrees", &x, &y, &degrees) != 3) {
    throw std::runtime_error("expected the robot's place: " + place);
  }
  return {mm_to_m(x), mm_to_m(y), deg_to_rad(degrees)};
}

std::string hdt_file(const Task& task, const ScratchFolder& folder) {
  const ProgramRun run = run_program({firmware_command(task, {"--hdt"}), {}, ""});
  if (run.exit_code != 0) throw std::runtime_error(run.err);
  return folder.write("robot.hdt", run.out);
}

}  // namespace eyebridge::testing
