#include "radio/radio_medium.hpp"

#include <atomic>

namespace eyebridge::hal {
namespace {

class MediumRadio final : public Radio {
 public:
  MediumRadio(std::shared_ptr<RadioMedium> medium, int id, const RadioErrors& errors, Clock& clock,
              RadioPlace place)
      : medium_(std::move(medium)),
        id_(id),
        errors_(errors),
        clock_(clock),
        place_(std::move(place)) {}
  ~MediumRadio() override { medium_->leave(id_); }
  MediumRadio(const MediumRadio&) = delete;
  MediumRadio& operator=(const MediumRadio&) = delete;

  [[nodiscard]] int id() const override { return id_; }
  Result<void> start() override {
    medium_->join(id_, errors_, place_);
    on_ = true;
    return {};
  }
  Result<void> stop() override {
    if (!on_.exchange(false)) return {};
    medium_->leave(id_);
    return {};
  }
  Result<void> send(int receiver, const std::string& text) override {
    if (!on_) return radio_is_off();
    return check_message(receiver, text).map([&] {
      medium_->send(receiver, {id_, text}, clock_.now());
    });
  }
  Result<std::optional<RadioMessage>> receive() override {
    if (!on_) return radio_is_off();
    return medium_->take(id_, clock_.now());
  }
  Result<std::vector<int>> robots() override {
    if (!on_) return radio_is_off();
    return medium_->robots();
  }

 private:
  const std::shared_ptr<RadioMedium> medium_;
  const int id_;
  const RadioErrors errors_;
  Clock& clock_;
  const RadioPlace place_;
  std::atomic<bool> on_ = false;
};

}  // namespace

void RadioMedium::join(int id, const RadioErrors& errors, const RadioPlace& place) {
  const std::lock_guard lock(mutex_);
  members_.try_emplace(id, Member{RadioInbox(id, errors), place});
}

void RadioMedium::leave(int id) {
  const std::lock_guard lock(mutex_);
  members_.erase(id);
}

void RadioMedium::send(int receiver, const RadioMessage& message, Time now) {
  const std::lock_guard lock(mutex_);
  const auto sender = members_.find(message.sender);
  for (auto& [id, member] : members_) {
    const bool is_meant = receiver == Radio::kEveryone ? id != message.sender : id == receiver;
    if (!is_meant) continue;
    const Member* const from = sender == members_.end() ? nullptr : &sender->second;
    member.inbox.add(message, now, reaches(from, member));
  }
}

bool RadioMedium::reaches(const Member* sender, const Member& receiver) {
  const double range = receiver.inbox.errors().range;
  if (range <= 0.0 || sender == nullptr || !sender->place || !receiver.place) return true;
  const std::optional<Vec2> from = sender->place();
  const std::optional<Vec2> to = receiver.place();
  return !from || !to || norm(*from - *to) <= range;
}

std::optional<RadioMessage> RadioMedium::take(int id, Time now) {
  const std::lock_guard lock(mutex_);
  const auto member = members_.find(id);
  if (member == members_.end()) return std::nullopt;
  std::optional<RadioMessage> message = member->second.inbox.take(now);
  if (message) {
    trace_.add(static_cast<std::uint64_t>(id));
    trace_.add(static_cast<std::uint64_t>(message->sender));
    trace_.add(static_cast<std::uint64_t>(now.count()));
    for (const char c : message->text) trace_.add_byte(static_cast<std::uint8_t>(c));
  }
  return message;
}

std::uint64_t RadioMedium::trace_value() {
  const std::lock_guard lock(mutex_);
  return trace_.value();
}

std::vector<int> RadioMedium::robots() {
  const std::lock_guard lock(mutex_);
  std::vector<int> ids;
  for (const auto& [id, member] : members_) ids.push_back(id);
  return ids;
}

std::unique_ptr<Radio> make_medium_radio(std::shared_ptr<RadioMedium> medium, int id,
                                         const RadioErrors& errors, Clock& clock,
                                         RadioPlace place) {
  return std::make_unique<MediumRadio>(std::move(medium), id, errors, clock, std::move(place));
}

}  // namespace eyebridge::hal
