#include "mix/mix_backend.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "mix/follow.hpp"

namespace eyebridge::hal {
namespace {

bool has(Backend& backend, std::string_view device) {
  if (device == "camera") return backend.camera_view() != nullptr;
  const std::optional<DeviceKind> named = kind_named(device);
  bool is_there = false;
  for_each_kind([&]<DeviceKind kind>() {
    for (int id = kKind<kind>.first_id; named == kind && id <= kKind<kind>.last_id; ++id) {
      is_there = is_there || backend.find(kind, id) != nullptr;
    }
  });
  return is_there;
}

class MixBackend final : public Backend {
 public:
  MixBackend(std::unique_ptr<Backend> main, std::vector<MixPart> parts) {
    check(*main, parts);
    Clock& clock = main->clock();
    std::vector<MixPart> all;
    all.push_back({{}, "", std::move(main)});
    std::ranges::move(parts, std::back_inserter(all));
    const auto drives = [](const MixPart& part) {
      return std::ranges::find(part.devices, "drive") != part.devices.end();
    };
    auto leader = std::ranges::find_if(all, drives);
    if (leader == all.end()) leader = all.begin();
    // The leader first: the others ask its drive.
    std::rotate(all.begin(), leader, leader + 1);
    for (MixPart& part : all) add(std::move(part), clock);
    begin_to_follow();
  }

  Clock& clock() override { return main_->clock(); }
  [[nodiscard]] int robot_id() const override { return main_->robot_id(); }
  Device* find(DeviceKind kind, int id) override { return of(name_of(kind)).find(kind, id); }
  [[nodiscard]] RadioConditions radio_conditions() const override {
    return main_->radio_conditions();
  }
  WorldControl* world() override { return main_->world(); }
  Environment* environment() override {
    if (Environment* const mains = main_->environment()) return mains;
    for (const auto& backend : backends_) {
      if (Environment* const other = backend->environment()) return other;
    }
    return nullptr;
  }
  camera::View* camera_view() override {
    Backend& backend = of("camera");
    const auto view = views_.find(&backend);
    return view == views_.end() ? backend.camera_view() : view->second.get();
  }
  camera::Source* camera_source() override { return of("camera").camera_source(); }
  std::vector<DeviceFacts> facts_of(std::string_view kind) override {
    return of(kind).facts_of(kind);
  }
  void trace_to(TraceSink* sink) override { main_->trace_to(sink); }
  std::string lost_results() override {
    for (const auto& backend : backends_) {
      if (std::string lost = backend->lost_results(); !lost.empty()) return lost;
    }
    return {};
  }
  Result<void> stop() noexcept override {
    Result<void> all;
    for (const auto& backend : backends_) {
      if (auto stopped = backend->stop(); !stopped) all = std::move(stopped);
    }
    return all;
  }

 private:
  static void check(Backend& main, const std::vector<MixPart>& parts) {
    for (const MixPart& part : parts) {
      if (main.clock().is_virtual() && !part.backend->clock().is_virtual()) {
        throw ConfigError({}, fmt::format("{} lives in real time and the robot in virtual time; "
                                          "expected both in real time: leave --fast out",
                                          part.url));
      }
      for (const std::string& device : part.devices) {
        if (has(*part.backend, device)) continue;
        throw ConfigError({}, fmt::format("{}={}: that robot has no {}", device, part.url, device));
      }
    }
  }

  void add(MixPart part, Clock& main_clock) {
    const bool is_main = &part.backend->clock() == &main_clock;
    const bool leads = backends_.empty();
    if (!leads && part.backend->world() != nullptr) followers_.push_back(part.backend->world());
    Follow follow{is_main ? nullptr : &main_clock, leads ? nullptr : part.backend->world(),
                  &tracker_, leads};
    backends_.push_back(make_following(std::move(part.backend), follow));
    Backend& backend = *backends_.back();
    if (is_main) main_ = &backend;
    for (const std::string& device : part.devices) {
      if (!has(backend, device)) {
        throw ConfigError({},
                          fmt::format("{0}={1}: that robot is put where the one that drives is, "
                                      "and feels no motion of its own; expected a {0} of the "
                                      "robot that drives",
                                      device, part.url));
      }
      by_device_[device] = &backend;
    }
    if (follow.world == nullptr) return;
    if (auto view = make_following_view(backend, follow)) views_[&backend] = std::move(view);
  }

  void begin_to_follow() {
    Backend& leader = *backends_.front();
    if (followers_.empty() || leader.drive() == nullptr) return;
    const auto start = followers_.front()->robot_pose(0);
    if (!start) throw ConfigError({}, start.error().what);
    // Where both are simulated the truth is known, which odometry may miss.
    const bool by_odometry = leader.world() == nullptr;
    const auto source = [this, &leader, by_odometry] {
      if (by_odometry) return leader.drive()->odometry();
      if (&leader != main_ && leader.clock().is_virtual()) {
        leader.clock().wait_until(clock().now());
      }
      return leader.world()->robot_pose(0);
    };
    if (const auto begun = tracker_.begin(source, by_odometry, *start); !begun) {
      throw ConfigError({}, begun.error().what);
    }
  }

  Backend& of(std::string_view device) {
    const auto found = by_device_.find(device);
    return found == by_device_.end() ? *main_ : *found->second;
  }

  PoseTracker tracker_;
  std::vector<std::unique_ptr<Backend>> backends_;  ///< The first one drives.
  std::map<Backend*, std::unique_ptr<camera::View>> views_;
  std::vector<WorldControl*> followers_;
  std::map<std::string, Backend*, std::less<>> by_device_;
  Backend* main_ = nullptr;
};

}  // namespace

std::unique_ptr<Backend> make_mix(std::unique_ptr<Backend> main, std::vector<MixPart> parts) {
  return std::make_unique<MixBackend>(std::move(main), std::move(parts));
}

}  // namespace eyebridge::hal
