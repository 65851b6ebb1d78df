#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "eyebridge/bridges/replay.hpp"

namespace eyebridge::bridges {

/// Where a replay stands: the next record to hand out and the next that has to be sent.
template <class Record>
class ReplayCursors {
 public:
  ReplayCursors(std::vector<Record> records, ReplayMode mode)
      : records_(std::move(records)), mode_(mode) {
    in_ = find(0, false);
    out_ = find(0, true);
  }

  [[nodiscard]] const Record* next_in() const { return at(in_); }
  [[nodiscard]] const Record* next_out() const { return at(out_); }
  void step_in() { in_ = find(in_ + 1, false); }
  void step_out() { out_ = find(out_ + 1, true); }

  /// Whether next_in() may be handed out: there is one, and what was sent before it has been sent.
  [[nodiscard]] bool is_readable() const {
    return in_ < records_.size() && (mode_ == ReplayMode::Lenient || out_ > in_);
  }
  /// Whether nothing will ever come again.
  [[nodiscard]] bool is_over() const {
    return in_ >= records_.size() && (mode_ == ReplayMode::Lenient || out_ >= records_.size());
  }
  [[nodiscard]] bool is_strict() const { return mode_ == ReplayMode::Strict; }
  /// The place of the next record to be sent, for messages: "record 3".
  [[nodiscard]] std::string place() const { return "record " + std::to_string(out_ + 1); }

 private:
  [[nodiscard]] const Record* at(std::size_t index) const {
    return index < records_.size() ? &records_[index] : nullptr;
  }
  [[nodiscard]] std::size_t find(std::size_t from, bool out) const {
    while (from < records_.size() && (records_[from].direction == Direction::Out) != out) ++from;
    return from;
  }

  std::vector<Record> records_;
  ReplayMode mode_;
  std::size_t in_ = 0;
  std::size_t out_ = 0;
};

}  // namespace eyebridge::bridges
