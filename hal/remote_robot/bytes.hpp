#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "calls/interceptor.hpp"

namespace eyebridge::hal {

/// Bytes of a message between two processes of one computer: numbers are as that has them, lists
/// and texts stand behind their length.
class ByteWriter {
 public:
  template <class Number>
  void number(Number value) {
    static_assert(std::is_arithmetic_v<Number>);
    const auto* const first = reinterpret_cast<const std::uint8_t*>(&value);
    bytes_.insert(bytes_.end(), first, first + sizeof value);
  }
  void flag(bool value) { number(static_cast<std::uint8_t>(value ? 1 : 0)); }
  void size(std::size_t value) { number(static_cast<std::uint32_t>(value)); }
  void text(std::string_view value) {
    size(value.size());
    bytes_.insert(bytes_.end(), value.begin(), value.end());
  }
  void values(std::span<const double> values) {
    size(values.size());
    for (const double value : values) number(value);
  }

  [[nodiscard]] std::vector<std::uint8_t> take() { return std::exchange(bytes_, {}); }
  [[nodiscard]] std::size_t written() const { return bytes_.size(); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Reads them. What is not there reads as 0, and the message is no good.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  template <class Number>
  Number number() {
    static_assert(std::is_arithmetic_v<Number>);
    Number value{};
    const auto bytes = take(sizeof value);
    if (!bytes.empty()) std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }
  bool flag() {
    const auto value = number<std::uint8_t>();
    good_ = good_ && value <= 1;
    return value == 1;
  }
  /// How many elements follow, of at least `bytes_each`: never more than there can be.
  std::size_t size(std::size_t bytes_each) {
    const std::size_t count = number<std::uint32_t>();
    good_ = good_ && count <= rest_.size() / bytes_each;
    return good_ ? count : 0;
  }
  std::string text() {
    const auto bytes = take(size(1));
    return {bytes.begin(), bytes.end()};
  }
  Values values() {
    Values values(size(sizeof(double)));
    for (double& value : values) value = number<double>();
    return values;
  }

  void refuse() { good_ = false; }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  /// Everything was there so far.
  [[nodiscard]] bool good() const { return good_; }
  /// Everything was there, and no more.
  [[nodiscard]] bool complete() const { return good_ && rest_.empty(); }

 private:
  std::span<const std::uint8_t> take(std::size_t count) {
    good_ = good_ && count <= rest_.size();
    if (!good_) return {};
    const auto taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }

  std::span<const std::uint8_t> rest_;
  bool good_ = true;
};

}  // namespace eyebridge::hal
