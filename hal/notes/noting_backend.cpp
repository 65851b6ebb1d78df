#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "eyebridge/hal/passing_backend.hpp"
#include "notes/noting_io.hpp"

namespace eyebridge::hal {
namespace {

constexpr int kMostIds = 255;

/// Devices of one kind by their ids. Made at once, so that finding one costs no lock.
template <class Device>
class Shelf {
 public:
  /// `make(id, name)` gives null for what the robot has not.
  template <class Make>
  Shelf(Backend& inner, std::string_view kind, const Make& make) {
    const std::vector<DeviceFacts> facts = inner.facts_of(kind);
    for (int id = 1; id <= kMostIds; ++id) {
      const auto fact = std::ranges::find(facts, id, &DeviceFacts::id);
      std::unique_ptr<Device> device = make(id, fact != facts.end() ? fact->name : std::string());
      if (!device) continue;
      devices_.resize(static_cast<std::size_t>(id));
      devices_.back() = std::move(device);
    }
  }
  [[nodiscard]] Device* at(int id) const {
    const auto index = static_cast<std::size_t>(id - 1);  // huge for 0 and less
    return index < devices_.size() ? devices_[index].get() : nullptr;
  }

 private:
  std::vector<std::unique_ptr<Device>> devices_;
};

template <class Device, class Inner, class... More>
std::unique_ptr<Device> wrapped(Inner* inner, DeviceNotes& notes, More&&... more) {
  if (inner == nullptr) return nullptr;
  return std::make_unique<Device>(*inner, notes, std::forward<More>(more)...);
}

class NotingBackend final : public PassingBackend {
 public:
  NotingBackend(std::unique_ptr<Backend> inner, std::shared_ptr<DeviceNotes> notes)
      : PassingBackend(std::move(inner)),
        notes_(std::move(notes)),
        drive_(wrapped<NotingDrive>(inner_->drive(), *notes_)),
        motors_(*inner_, "motor",
                [this](int id, const std::string& name) {
                  return wrapped<NotingMotor>(inner_->motor(id), *notes_, id, name);
                }),
        encoders_(*inner_, "encoder",
                  [this](int id, const std::string& name) {
                    return wrapped<NotingEncoder>(inner_->encoder(id), *notes_, id, name);
                  }),
        servos_(*inner_, "servo",
                [this](int id, const std::string& name) {
                  return wrapped<NotingServo>(inner_->servo(id), *notes_, id, name);
                }),
        range_sensors_(*inner_, "psd",
                       [this](int id, const std::string& name) {
                         return wrapped<NotingRangeSensor>(inner_->range_sensor(id), *notes_, id,
                                                           name);
                       }),
        proximity_(*inner_, "proximity",
                   [this](int id, const std::string& name) {
                     return wrapped<NotingSwitchSensor>(inner_->proximity(id), *notes_, "proximity",
                                                        id, name);
                   }),
        bumpers_(*inner_, "bumper",
                 [this](int id, const std::string& name) {
                   return wrapped<NotingSwitchSensor>(inner_->bumper(id), *notes_, "bumper", id,
                                                      name);
                 }),
        lidar_(wrapped<NotingLidar>(inner_->lidar(), *notes_)),
        compass_(wrapped<NotingCompass>(inner_->compass(), *notes_)),
        gyroscope_(wrapped<NotingGyroscope>(inner_->gyroscope(), *notes_)),
        accelerometer_(wrapped<NotingAccelerometer>(inner_->accelerometer(), *notes_)),
        digital_(wrapped<NotingDigitalLines>(inner_->digital(), *notes_)),
        analog_(wrapped<NotingAnalogInputs>(inner_->analog(), *notes_)),
        remote_(wrapped<NotingRemote>(inner_->remote(), *notes_)),
        sound_(wrapped<NotingSound>(inner_->sound(), *notes_)) {}

  Drive* drive() override { return drive_.get(); }
  Motor* motor(int id) override { return motors_.at(id); }
  Encoder* encoder(int id) override { return encoders_.at(id); }
  Servo* servo(int id) override { return servos_.at(id); }
  RangeSensor* range_sensor(int id) override { return range_sensors_.at(id); }
  SwitchSensor* proximity(int id) override { return proximity_.at(id); }
  SwitchSensor* bumper(int id) override { return bumpers_.at(id); }
  Lidar* lidar() override { return lidar_.get(); }
  Compass* compass() override { return compass_.get(); }
  Gyroscope* gyroscope() override { return gyroscope_.get(); }
  Accelerometer* accelerometer() override { return accelerometer_.get(); }
  DigitalLines* digital() override { return digital_.get(); }
  AnalogInputs* analog() override { return analog_.get(); }
  Remote* remote() override { return remote_.get(); }
  Sound* sound() override { return sound_.get(); }

 private:
  const std::shared_ptr<DeviceNotes> notes_;
  // In the order of the rows.
  const std::unique_ptr<NotingDrive> drive_;
  const Shelf<NotingMotor> motors_;
  const Shelf<NotingEncoder> encoders_;
  const Shelf<NotingServo> servos_;
  const Shelf<NotingRangeSensor> range_sensors_;
  const Shelf<NotingSwitchSensor> proximity_;
  const Shelf<NotingSwitchSensor> bumpers_;
  const std::unique_ptr<NotingLidar> lidar_;
  const std::unique_ptr<NotingCompass> compass_;
  const std::unique_ptr<NotingGyroscope> gyroscope_;
  const std::unique_ptr<NotingAccelerometer> accelerometer_;
  const std::unique_ptr<NotingDigitalLines> digital_;
  const std::unique_ptr<NotingAnalogInputs> analog_;
  const std::unique_ptr<NotingRemote> remote_;
  const std::unique_ptr<NotingSound> sound_;
};

}  // namespace

NotedBackend with_notes(std::unique_ptr<Backend> inner) {
  auto notes = std::make_shared<DeviceNotes>(inner->clock());
  return {std::make_unique<NotingBackend>(std::move(inner), notes), notes};
}

}  // namespace eyebridge::hal
