#pragma once

namespace eyebridge::robios {

/// For how long the program that all wait for has run without an end: what it computes counts by
/// the processor's time, as the computer may be busy with other things, what it waits for by how
/// often it is seen to wait.
class HoldUp {
 public:
  /// `processor_s`: of the program so far; every `period_s`.
  void look(double processor_s, bool sleeps, double period_s) {
    constexpr double kNothing_s = 0.001;
    is_waiting_ = sleeps && processor_s - processor_s_ < kNothing_s;
    if (is_waiting_) waited_s_ += period_s;
    processor_s_ = processor_s;
  }
  /// Seconds so far.
  [[nodiscard]] double processor_s() const { return processor_s_; }
  [[nodiscard]] double waited_s() const { return waited_s_; }
  /// At the last look.
  [[nodiscard]] bool is_waiting() const { return is_waiting_; }

 private:
  double processor_s_ = 0.0;
  double waited_s_ = 0.0;
  bool is_waiting_ = false;
};

}  // namespace eyebridge::robios
