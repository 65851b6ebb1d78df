#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "calls/device_calls.hpp"
#include "calls/exchange.hpp"
#include "eyebridge/hal/passing_backend.hpp"

namespace eyebridge::hal {
namespace {

/// A device behind an interceptor: its calls become numbers on their way, and replies become
/// values.
template <class Interface>
class Intercepted : public Interface {
 public:
  Intercepted(CallInterceptor& interceptor, std::string_view kind, int id, Interface& inner)
      : interceptor_(interceptor), kind_(kind), id_(id), inner_(inner) {}

 protected:
  template <class Answer, class... Args>
  Result<Answer> carry(const DeviceCall<Interface, Answer, Args...>& row,
                       std::type_identity_t<Args>... args) {
    const Call call{kind_, id_of(row, id_, args...), row.name, row.is_command(),
                    request_of(row, args...)};
    const Result<Values> reply = interceptor_.exchange(
        call, [&]() -> Result<Values> { return reply_of((inner_.*row.method)(args...), args...); });
    return answer_of<Answer>(call, row.style, reply, args...);
  }
  template <class Fact>
  Fact fact(Fact (Interface::*method)() const) const {
    return (inner_.*method)();
  }

 private:
  CallInterceptor& interceptor_;
  std::string_view kind_;
  int id_;
  Interface& inner_;
};

class InterceptedBackend final : public PassingBackend {
 public:
  InterceptedBackend(std::unique_ptr<Backend> inner, const InterceptorMaker& make_interceptor)
      : PassingBackend(std::move(inner)), interceptor_(make_interceptor(*inner_)) {}

  Device* find(DeviceKind kind, int id) override {
    Device* const device = inner_->find(kind, id);
    if (device == nullptr) return nullptr;
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Device>& wrapper = devices_[{kind, id}];
    if (!wrapper) wrapper = wrapped(kind, id, *device);
    return wrapper.get();
  }
  camera::FrameSink* frame_sink() override {
    camera::FrameSink* own = interceptor_->frame_sink();
    return own != nullptr ? own : inner_->frame_sink();
  }
  std::string lost_results() override {
    std::string own = interceptor_->lost();
    return own.empty() ? inner_->lost_results() : own;
  }
  Result<void> stop() noexcept override {
    auto stopped = inner_->stop();
    interceptor_->finish();
    return stopped;
  }

 private:
  std::unique_ptr<Device> wrapped(DeviceKind wanted, int id, Device& device) {
    std::unique_ptr<Device> made;
    for_each_kind([&]<DeviceKind kind>() {
      if (kind != wanted) return;
      using Interface = InterfaceOf<kind>;
      made = std::make_unique<Relay<Interface, Intercepted<Interface>>>(
          *interceptor_, name_of(kind), id, static_cast<Interface&>(device));
    });
    return made;
  }

  std::unique_ptr<CallInterceptor> interceptor_;
  std::mutex mutex_;
  /// Made when they are first asked for.
  std::map<std::pair<DeviceKind, int>, std::unique_ptr<Device>> devices_;
};

}  // namespace

std::unique_ptr<Backend> with_interceptor(std::unique_ptr<Backend> inner,
                                          const InterceptorMaker& make_interceptor) {
  return std::make_unique<InterceptedBackend>(std::move(inner), make_interceptor);
}

}  // namespace eyebridge::hal
