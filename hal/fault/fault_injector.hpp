#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "calls/interceptor.hpp"
#include "eyebridge/base/random.hpp"
#include "fault/fault_script.hpp"

namespace eyebridge::hal {

/// Lets calls through, or not, as a script says. What is dropped by chance follows from `seed` and
/// the device alone. `clock` is lent.
class FaultInjector final : public CallInterceptor {
 public:
  FaultInjector(FaultScript script, Clock& clock, std::uint64_t seed);

  Result<Values> exchange(const Call& call, const std::function<Result<Values>()>& device) override;

 private:
  /// Waits as the script says; whether the device is frozen. Fails with Disconnected or Timeout.
  Result<bool> pass(const Call& call);
  bool dropped(const Call& call, double share);

  const FaultScript script_;
  Clock& clock_;
  const std::uint64_t seed_;
  std::mutex mutex_;
  std::map<std::pair<std::string, int>, Random> random_;
  std::map<std::string, Values> last_;  ///< Of each reading, by "psd 1 read".
};

/// `inner` with devices that fail by `script`.
std::unique_ptr<Backend> with_faults(std::unique_ptr<Backend> inner, FaultScript script,
                                     std::uint64_t seed);

}  // namespace eyebridge::hal
