#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "eyebridge/base/result.hpp"
#include "eyebridge/bridges/can/identifier.hpp"
#include "eyebridge/bridges/can/table.hpp"

namespace eyebridge::bridges::can {

/// The most signals that one frame carries.
inline constexpr std::size_t kMaxSignals = 33;

/// The raw values of one frame, in the order of the table's signals; of a multiplexed message only
/// those of its bank.
struct RawValues {
  std::array<std::int64_t, kMaxSignals> values{};
  std::size_t count = 0;

  constexpr void push(std::int64_t value) {
    if (count < values.size()) values[count] = value;
    ++count;
  }
  [[nodiscard]] std::span<const std::int64_t> view() const { return {values.data(), count}; }
};

/// Packs `values` into a frame to or from `node`. Fails with OutOfRange, naming the signal, its
/// range and what was given; so does a node that this message is never sent to. Unused bits are 0.
/// Does not allocate unless it fails.
Result<CanFrame> encode_raw(const MessageSpec& spec, int node,
                            std::span<const std::int64_t> values);

/// Unpacks a frame. Fails with Corrupt when it is shorter than the table says, when a value is
/// outside its range or its node is impossible; with Unsupported when it is no frame of `spec`.
/// Bytes after the expected ones and unused bits are ignored, so that later versions may fill them.
Result<RawValues> decode_raw(const MessageSpec& spec, const CanFrame& frame);

namespace detail {

template <class Field>
inline constexpr bool kIsArray = false;
template <class Element, std::size_t N>
inline constexpr bool kIsArray<std::array<Element, N>> = true;

template <class Message>
RawValues to_raw(const Message& message) {
  RawValues raw;
  const auto put = [&raw](const auto& field) {
    if constexpr (kIsArray<std::remove_cvref_t<decltype(field)>>) {
      for (const auto element : field) raw.push(static_cast<std::int64_t>(element));
    } else {
      raw.push(static_cast<std::int64_t>(field));
    }
  };
  Message::visit(message, [&put](const auto&... fields) { (put(fields), ...); });
  return raw;
}

template <class Message>
Message from_raw(const RawValues& raw) {
  Message message;
  std::size_t at = 0;
  const auto take = [&](auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (kIsArray<Field>) {
      for (auto& element : field) {
        element = static_cast<typename Field::value_type>(raw.values[at++]);
      }
    } else {
      field = static_cast<Field>(raw.values[at++]);
    }
  };
  Message::visit(message, [&take](auto&... fields) { (take(fields), ...); });
  return message;
}

}  // namespace detail

/// The table's row of a message type.
template <class Message>
const MessageSpec& spec_of() {
  return *find_message(Message::kFunction, Message::kFd);
}

/// Packs a typed message; fails as encode_raw does.
template <class Message>
Result<CanFrame> encode(int node, const Message& message) {
  return encode_raw(spec_of<Message>(), node, detail::to_raw(message).view());
}

/// Unpacks a typed message; fails as decode_raw does.
template <class Message>
Result<Message> decode(const CanFrame& frame) {
  auto raw = decode_raw(spec_of<Message>(), frame);
  if (!raw) return tl::unexpected(std::move(raw.error()));
  return detail::from_raw<Message>(*raw);
}

}  // namespace eyebridge::bridges::can
