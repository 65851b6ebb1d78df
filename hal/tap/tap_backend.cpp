#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "eyebridge/hal/passing_backend.hpp"
#include "tap/device_calls.hpp"
#include "tap/exchange.hpp"

namespace eyebridge::hal {
namespace {

/// A device behind a tap: its calls become numbers on their way, and replies become values.
template <class Interface>
class Tapped : public Interface {
 public:
  Tapped(Tap& tap, std::string_view kind, int id, Interface& inner)
      : tap_(tap), kind_(kind), id_(id), inner_(inner) {}

 protected:
  template <class Answer, class... Args>
  Result<Answer> carry(const DeviceCall<Interface, Answer, Args...>& row,
                       std::type_identity_t<Args>... args) {
    const Call call{kind_, id_of(row, id_, args...), row.name, row.is_command(),
                    request_of(row, args...)};
    const Result<Values> reply = tap_.exchange(
        call, [&]() -> Result<Values> { return reply_of((inner_.*row.method)(args...), args...); });
    return answer_of<Answer>(call, row.style, reply, args...);
  }
  template <class Fact>
  Fact fact(Fact (Interface::*method)() const) const {
    return (inner_.*method)();
  }

 private:
  Tap& tap_;
  std::string_view kind_;
  int id_;
  Interface& inner_;
};

class TapBackend final : public PassingBackend {
 public:
  TapBackend(std::unique_ptr<Backend> inner, const TapMaker& make_tap)
      : PassingBackend(std::move(inner)), tap_(make_tap(*inner_)) {}

  Device* find(DeviceKind kind, int id) override {
    Device* const device = inner_->find(kind, id);
    if (device == nullptr) return nullptr;
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Device>& tapped = devices_[{kind, id}];
    if (!tapped) tapped = wrapped(kind, id, *device);
    return tapped.get();
  }
  camera::FrameSink* frame_sink() override {
    camera::FrameSink* own = tap_->frame_sink();
    return own != nullptr ? own : inner_->frame_sink();
  }
  Result<void> stop() noexcept override {
    auto stopped = inner_->stop();
    tap_->finish();
    return stopped;
  }

 private:
  std::unique_ptr<Device> wrapped(DeviceKind wanted, int id, Device& device) {
    std::unique_ptr<Device> made;
    for_each_kind([&]<DeviceKind kind>() {
      if (kind != wanted) return;
      using Interface = InterfaceOf<kind>;
      made = std::make_unique<Relay<Interface, Tapped<Interface>>>(*tap_, name_of(kind), id,
                                                                   static_cast<Interface&>(device));
    });
    return made;
  }

  std::unique_ptr<Tap> tap_;
  std::mutex mutex_;
  /// Made when they are first asked for.
  std::map<std::pair<DeviceKind, int>, std::unique_ptr<Device>> devices_;
};

}  // namespace

std::unique_ptr<Backend> make_tapped(std::unique_ptr<Backend> inner, const TapMaker& make_tap) {
  return std::make_unique<TapBackend>(std::move(inner), make_tap);
}

}  // namespace eyebridge::hal
