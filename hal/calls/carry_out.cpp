#include "calls/carry_out.hpp"

#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "calls/exchange.hpp"

namespace eyebridge::hal {
namespace {

tl::unexpected<Error> no_such(const Call& call) {
  return fail(Errc::Unsupported,
              fmt::format("this robot has no {} {} {}", call.device, call.id, call.name));
}

/// A request's numbers, one argument after the other.
class Reader {
 public:
  explicit Reader(const Call& call, bool first_is_id)
      : call_(call), rest_(call.request), first_is_id_(first_is_id) {}

  template <class Arg>
  Arg take() {
    if constexpr (std::is_same_v<Arg, int>) {
      if (std::exchange(first_is_id_, false)) return call_.id;
    }
    constexpr std::size_t kSize = AsValues<Arg>::kSize;
    const std::size_t size = kSize == kAnyLength ? rest_.size() : kSize;
    if (rest_.size() < size) {
      is_short_ = true;
      return Arg{};
    }
    const auto own = rest_.first(size);
    rest_ = rest_.subspan(size);
    return AsValues<Arg>::unpack(own);
  }
  [[nodiscard]] bool fits() const { return !is_short_ && rest_.empty(); }

 private:
  const Call& call_;
  std::span<const double> rest_;
  bool first_is_id_;
  bool is_short_ = false;
};

/// How many numbers the request of a call has; those of a text are not counted.
template <class Arg>
constexpr std::size_t size_of() {
  return AsValues<Arg>::kSize == kAnyLength ? 0 : AsValues<Arg>::kSize;
}

template <class Interface, class Answer, class... Args>
Result<Values> carry_out(Interface& device, const DeviceCall<Interface, Answer, Args...>& row,
                         const Call& call) {
  if constexpr (sizeof...(Args) == 0) {
    return reply_of((device.*row.method)());
  } else {
    Reader reader(call, row.is_of_line);
    const std::tuple<std::remove_cvref_t<Args>...> args{
        reader.take<std::remove_cvref_t<Args>>()...};
    if (!reader.fits()) {
      const std::size_t expected = (size_of<std::remove_cvref_t<Args>>() + ...) - row.is_of_line;
      return fail(Errc::Corrupt,
                  fmt::format("{} {} {}: {} numbers in the request, expected {}", call.device,
                              call.id, call.name, call.request.size(), expected));
    }
    return std::apply(
        [&](const auto&... each) { return reply_of((device.*row.method)(each...), each...); },
        args);
  }
}
/// The room for a scan is its own.
Result<Values> carry_out(Lidar& lidar, const DeviceCall<Lidar, void, std::span<double>>&,
                         const Call&) {
  Values ranges(static_cast<std::size_t>(std::max(lidar.points(), 0)));
  return lidar.read(ranges).map([&] { return std::move(ranges); });
}

template <class Interface>
Result<Values> ask(Interface& device, const Call& call) {
  std::optional<Result<Values>> reply;
  const auto try_row = [&](const auto& row) {
    if (row.name == call.name) reply = carry_out(device, row, call);
  };
  std::apply([&](const auto&... rows) { (try_row(rows), ...); }, Calls<Interface>::kAll);
  return reply ? std::move(*reply) : no_such(call);
}

}  // namespace

Result<Values> carry_out(Backend& robot, const Call& call) {
  const std::optional<DeviceKind> named = kind_named(call.device);
  std::optional<Result<Values>> reply;
  for_each_kind([&]<DeviceKind kind>() {
    if constexpr (kind != DeviceKind::Serial && kind != DeviceKind::Sound) {
      if (named != kind) return;
      // Only the number of a device that has one is looked at: else it may be that of a line.
      const bool is_alone = kKind<kind>.first_id == kKind<kind>.last_id;
      auto* const device = robot.device<kind>(is_alone ? kKind<kind>.first_id : call.id);
      if (device != nullptr) reply = ask(*device, call);
    }
  });
  return reply ? std::move(*reply) : no_such(call);
}

}  // namespace eyebridge::hal
