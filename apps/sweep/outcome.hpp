#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace eyebridge::apps {

/// What came of one run.
struct Outcome {
  /// How it ended: "ended" (exit code 0), "time limit" (likewise, when its robot's time was up),
  /// "failed" (another exit code), "crashed" (a signal), "hung" (killed after the wall limit),
  /// "not started".
  std::string how;
  std::string reason;            ///< Of anything but "ended": one line for people.
  std::optional<int> exit_code;  ///< Null when a signal ended it.
  std::optional<int> signal;
  std::optional<double> time;      ///< On the robot's clock, s; null for one that used no robot.
  std::optional<double> distance;  ///< Driven by all robots, m.
  std::optional<std::uint64_t> collisions;
  std::string state_hash;  ///< 16 hexadecimal digits; "" unless the program ended by itself.
  double wall = 0.0;       ///< Real time, s.
  double cpu = 0.0;        ///< Processor time with its children, s.
  /// What else its report says (end_x, end_y, end_theta; coverage, observed, agreement of a control
  /// file's belief), then lines "result NAME VALUE" of its output: the last of each name, in order
  /// of first appearance; "result.NAME" where the report has that name, too.
  std::vector<std::pair<std::string, std::string>> results;

  [[nodiscard]] bool well() const { return how == "ended" || how == "time limit"; }
};

/// Adds to `outcome` what the files of a run say: its report and the results in its output.
void read_files(Outcome& outcome, const std::filesystem::path& report,
                const std::filesystem::path& output);

/// The last line of a file that is not blank, cut to 200 bytes; "" when there is none.
std::string last_line(const std::filesystem::path& file);

/// "SIGSEGV" of 11; "signal 64" of one without a name.
std::string signal_name(int signal);

/// As one text, for another process; and back. from_text() throws std::runtime_error for what
/// to_text() does not write.
std::string to_text(const Outcome& outcome);
Outcome outcome_from_text(const std::string& text);

}  // namespace eyebridge::apps
