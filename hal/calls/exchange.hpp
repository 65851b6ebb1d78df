#pragma once

#include <algorithm>
#include <span>
#include <type_traits>
#include <utility>

#include "calls/device_calls.hpp"
#include "calls/values.hpp"

namespace eyebridge::hal {

// A call's arguments as the numbers of its request, its answer as those of its reply, and back.

/// An argument into which the device writes what it answers.
template <class Arg>
inline constexpr bool is_room = std::is_same_v<std::remove_cvref_t<Arg>, std::span<double>> ||
                                std::is_same_v<std::remove_cvref_t<Arg>, std::span<std::uint8_t>>;

template <class Arg>
void append_argument(Values& request, const Arg& arg) {
  if constexpr (std::is_same_v<Arg, std::span<std::uint8_t>>) {
    append(request, arg.size());
  } else if constexpr (!is_room<Arg>) {
    append(request, arg);
  }
}

/// The id that scripts and recordings see.
template <class Row, class... Args>
int id_of(const Row& row, int device_id, const Args&... args) {
  if constexpr (sizeof...(Args) > 0) {
    const auto& first = std::get<0>(std::tie(args...));
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(first)>, int>) {
      if (row.is_of_line) return first;
    }
  }
  return row.id.value_or(device_id);
}

template <class Row, class... Args>
Values request_of(const Row& row, const Args&... args) {
  Values request;
  [[maybe_unused]] bool is_id = row.is_of_line;
  [[maybe_unused]] const auto add = [&](const auto& arg) {
    if (!std::exchange(is_id, false)) append_argument(request, arg);
  };
  (add(args), ...);
  return request;
}

/// The numbers of what a device answered to `args`.
template <class Answer, class... Args>
Result<Values> reply_of(const Result<Answer>& answer, const Args&... args) {
  if (!answer) return tl::unexpected(answer.error());
  Values reply;
  if constexpr ((is_room<Args> || ...)) {
    const auto take = [&](const auto& arg) {
      if constexpr (is_room<decltype(arg)>) {
        std::size_t count = arg.size();
        if constexpr (!std::is_void_v<Answer>) count = *answer;
        reply.assign(arg.begin(), arg.begin() + static_cast<std::ptrdiff_t>(count));
      }
    };
    (take(args), ...);
  } else if constexpr (!std::is_void_v<Answer>) {
    append(reply, *answer);
  }
  return reply;
}

/// A scan must be as long as its room …
inline Result<void> put_reply(const Call& call, const Values& reply, std::span<double> room) {
  if (reply.size() != room.size()) {
    return fail(Errc::Corrupt, fmt::format("{}: a scan of {} points, expected {}", call.device,
                                           reply.size(), room.size()));
  }
  std::ranges::copy(reply, room.begin());
  return {};
}
/// … bytes may be fewer.
inline Result<std::size_t> put_reply(const Call& call, const Values& reply,
                                     std::span<std::uint8_t> room) {
  if (reply.size() > room.size()) {
    return fail(Errc::Corrupt, fmt::format("{} {}: {} bytes in the reply, expected at most {}",
                                           call.device, call.id, reply.size(), room.size()));
  }
  std::ranges::transform(reply, room.begin(),
                         [](double value) { return static_cast<std::uint8_t>(to_byte(value)); });
  return reply.size();
}

/// A reply as the value that the caller expects. Corrupt when it cannot be one.
template <class Answer, class... Args>
Result<Answer> answer_of(const Call& call, CallStyle style, const Result<Values>& reply,
                         const Args&... args) {
  if (!reply) return tl::unexpected(reply.error());
  if constexpr ((is_room<Args> || ...)) {
    return put_reply(call, *reply, std::get<0>(std::tie(args...)));
  } else if constexpr (std::is_void_v<Answer>) {
    return {};
  } else {
    if (style == CallStyle::Takes && reply->empty()) return Answer{};
    return reply_as<Answer>(call, reply);
  }
}

}  // namespace eyebridge::hal
