#include "simulated_robot.hpp"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "run_program.hpp"

namespace eyebridge::testing {
namespace {

std::string world_file(const Task& task) { return EYEBRIDGE_SOURCE_DIR "/worlds/" + task.world; }

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
  std::vector<Task> all;
  const char* const size = std::getenv("EYEBRIDGE_TEST_PARITY");
  if (size == nullptr || std::string(size) != "short") {
    all = {{"square", {EYEBRIDGE_EXAMPLES "/square"}, "empty-room.wld"},
           {"wall follower", {EYEBRIDGE_BIN "/parity_follower"}, "corridor.wld"},
           {"maze explorer", {EYEBRIDGE_EXAMPLES "/maze_explorer"}, "maze-5.maz", "Mouse"}};
  }
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

std::vector<std::string> firmware_arguments(const Task& task) {
  return {"--world", world_file(task), "--robot", task.robot};
}

}  // namespace eyebridge::testing
