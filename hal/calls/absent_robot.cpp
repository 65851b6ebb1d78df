#include "calls/absent_robot.hpp"

#include <map>
#include <optional>
#include <span>
#include <utility>

#include "arguments/arguments.hpp"
#include "calls/device_calls.hpp"
#include "calls/values.hpp"
#include "clock/lockstep_clock.hpp"
#include "eyebridge/base/config_error.hpp"

namespace eyebridge::hal {
namespace {

/// The types of facts.
template <class Methods>
struct TypesOf;
template <class... Facts, class Interface>
struct TypesOf<const std::tuple<Facts (Interface::*)() const...>> {
  using Types = std::tuple<Facts...>;
};
template <>
struct TypesOf<const std::tuple<>> {
  using Types = std::tuple<>;
};

/// A device that only an interceptor answers for. It says of itself what was listed; every call
/// fails with Unsupported.
template <class Interface>
class Absent : public Interface {
 public:
  using Facts = typename TypesOf<decltype(Calls<Interface>::kFacts)>::Types;
  explicit Absent(Facts facts) : facts_(std::move(facts)) {}

 protected:
  template <class Answer, class... Args>
  Result<Answer> carry(const DeviceCall<Interface, Answer, Args...>&, const auto&...) {
    return fail(Errc::Unsupported, "there is nothing behind this device");
  }
  template <class Fact>
  Fact fact(Fact (Interface::*)() const) const {
    return std::get<Fact>(facts_);
  }

  Facts facts_;
};

/// Keeps the shape that the program asked for, so that it can ask for it again, and knows how much
/// room a scan needs.
class AbsentLidar final : public Relay<Lidar, Absent<Lidar>> {
 public:
  using Relay::Relay;
  Result<void> configure(double field_of_view, double tilt, int points) override {
    std::get<LidarShape>(facts_) = {field_of_view, tilt, points};
    return {};
  }
  Result<void> read(std::span<double> ranges) override {
    return check_scan_size(ranges.size(), points()).and_then([&] { return Relay::read(ranges); });
  }
};

/// What a list says of a device; none where it cannot be.
template <class... Facts>
std::optional<std::tuple<Facts...>> read_facts(std::span<const double> values,
                                               std::type_identity<std::tuple<Facts...>>) {
  if (values.size() != (std::size_t{0} + ... + AsValues<Facts>::kSize)) return std::nullopt;
  [[maybe_unused]] const auto next = [&]<class Fact>(std::type_identity<Fact>) {
    const auto own = values.first(AsValues<Fact>::kSize);
    values = values.subspan(AsValues<Fact>::kSize);
    return AsValues<Fact>::unpack(own);
  };
  return std::tuple<Facts...>{next(std::type_identity<Facts>{})...};
}

/// Whether a device can be as its facts say.
template <class Facts>
bool is_possible(const Facts&) {
  return true;
}
bool is_possible(const std::tuple<int>& radio) {
  return std::get<int>(radio) >= Radio::kFirstId && std::get<int>(radio) <= Radio::kLastId;
}
bool is_possible(const std::tuple<double, LidarShape>& lidar) {
  const int points = std::get<LidarShape>(lidar).points;
  return points >= 1 && points <= 36000;
}

/// Null: there is no such device.
template <class Interface>
std::unique_ptr<Device> make_absent(const Values& listed) {
  auto facts = read_facts(listed, std::type_identity<typename Absent<Interface>::Facts>{});
  if (!facts || !is_possible(*facts)) return nullptr;
  if constexpr (std::is_same_v<Interface, Lidar>) {
    return std::make_unique<AbsentLidar>(std::move(*facts));
  } else {
    return std::make_unique<Relay<Interface, Absent<Interface>>>(std::move(*facts));
  }
}

class AbsentRobot final : public Backend {
 public:
  void add(const ListedDevice& listed) {
    const std::optional<DeviceKind> named = kind_named(listed.kind);
    std::unique_ptr<Device> device;
    for_each_kind([&]<DeviceKind kind>() {
      if (named == kind) device = make_absent<InterfaceOf<kind>>(listed.facts);
    });
    if (!device) throw ConfigError({}, "unknown device '" + listed.kind.substr(0, 40) + "'");
    devices_.try_emplace({*named, listed.id}, std::move(device));
  }

  Clock& clock() override { return clock_; }
  [[nodiscard]] int robot_id() const override { return 1; }
  Device* find(DeviceKind kind, int id) override {
    const auto found = devices_.find({kind, id});
    return found == devices_.end() ? nullptr : found->second.get();
  }
  WorldControl* world() override { return nullptr; }
  camera::View* camera_view() override { return nullptr; }
  camera::Source* camera_source() override { return nullptr; }
  std::vector<DeviceFacts> facts_of(std::string_view) override { return {}; }  // not listed
  void trace_to(TraceSink*) override {}  // nobody knows where the robot was
  Result<void> stop() noexcept override { return {}; }

 private:
  LockstepClock clock_{std::chrono::milliseconds(10), [] {}};
  std::map<std::pair<DeviceKind, int>, std::unique_ptr<Device>> devices_;
};

}  // namespace

std::unique_ptr<Backend> make_absent_robot(const std::vector<ListedDevice>& devices) {
  auto robot = std::make_unique<AbsentRobot>();
  for (const ListedDevice& device : devices) robot->add(device);
  return robot;
}

}  // namespace eyebridge::hal
