#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "eyebridge/hal/backend.hpp"

namespace eyebridge::hal {

/// The numbers of a request or a reply, in SI units, in the order of the fields of its type.
using Values = std::vector<double>;

/// One call of a device, whatever its types.
struct Call {
  std::string_view device;  ///< "psd": the kind, as scripts and recordings name it.
  int id = 1;
  std::string_view name;  ///< "read"
  /// It changes something, or takes what came once; an empty answer will do.
  bool is_command = false;
  Values request;
};

/// Stands in every call to a backend's devices: the one place for what concerns them all.
class CallInterceptor {
 public:
  virtual ~CallInterceptor() = default;
  /// Answers `call`, perhaps by asking `device`, which may be called at most once. Any thread.
  virtual Result<Values> exchange(const Call& call,
                                  const std::function<Result<Values>()>& device) = 0;
  /// As Backend::frame_sink().
  virtual camera::FrameSink* frame_sink() { return nullptr; }
  /// The program has ended: what is in hand must be put away now. May come more than once.
  virtual void finish() noexcept {}
  /// As Backend::lost_results().
  virtual std::string lost() { return {}; }
};

/// Makes the interceptor of a backend, which outlives it.
using InterceptorMaker = std::function<std::unique_ptr<CallInterceptor>(Backend& inner)>;

/// `inner` with an interceptor in front of all its devices. The clock, the world, the camera's
/// view, traces and stop() are the inner one's: motors stop whatever the interceptor does.
std::unique_ptr<Backend> with_interceptor(std::unique_ptr<Backend> inner,
                                          const InterceptorMaker& make_interceptor);

}  // namespace eyebridge::hal
