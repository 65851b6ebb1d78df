#include "keys.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace eyebridge::robios {
namespace {

constexpr int kAllKeys = 1 | 2 | 4 | 8;
// How long a wait leaves the terminal and the window unasked. A person does not notice 10 ms.
constexpr std::chrono::milliseconds kSlice{10};
constexpr std::array kNames{"key", "touch", "key of the remote control"};  // by Keys::Wanted

bool is_key(int key) { return key == 1 || key == 2 || key == 4 || key == 8; }

}  // namespace

Keys::Keys(Clock& clock, std::vector<ScriptedKey> script, std::unique_ptr<KeyInput> terminal)
    : clock_(clock), script_(std::move(script)), terminal_(std::move(terminal)) {}

void Keys::set_touch_map(std::function<int(int x, int y)> key_at) {
  const std::lock_guard lock(mutex_);
  key_at_ = std::move(key_at);
}

void Keys::set_window(bool attached) {
  const std::lock_guard lock(mutex_);
  window_ = attached;
  pressed_.notify_all();
}

void Keys::press(int key) {
  if (!is_key(key)) {
    return;
  }
  const std::lock_guard lock(mutex_);
  presses_.push_back(key);
  ++inputs_;
  pressed_.notify_all();
}

void Keys::touch(int x, int y) {
  const std::lock_guard lock(mutex_);
  add_touch({x, y});
  ++inputs_;
  pressed_.notify_all();
}

void Keys::add_touch(TouchPoint point) {
  last_touch_ = point;
  const int key = key_at_ ? key_at_(point.x, point.y) : 0;
  if (is_key(key)) {
    presses_.push_back(key);
  }
}

void Keys::take_script() {
  const Time now = clock_.now();
  for (; next_ < script_.size() && script_[next_].at <= now; ++next_) {
    if (script_[next_].key != 0) {
      presses_.push_back(script_[next_].key);
    } else if (script_[next_].remote != 0) {
      remote_.push_back(script_[next_].remote);
    } else {
      add_touch(script_[next_].touch);
    }
  }
}

void Keys::take_terminal(std::chrono::milliseconds timeout) {
  if (terminal_ == nullptr) {
    return;
  }
  const std::lock_guard lock(terminal_mutex_);
  const KeyEvent event = terminal_->poll(timeout);
  press(event.key);
  take_remote(event.remote);
  if (event.touch) touch(event.touch->x, event.touch->y);
}

int Keys::read() {
  take_terminal(std::chrono::milliseconds{0});
  const std::lock_guard lock(mutex_);
  take_script();
  return next_key(kAllKeys).value_or(0);
}

std::optional<int> Keys::next_key(int mask) {
  while (!presses_.empty()) {
    const int key = presses_.front();
    presses_.pop_front();
    if ((key & mask) == 0) continue;
    given_.key = key;
    given_.key_at = clock_.now();
    return key;
  }
  return std::nullopt;
}

std::optional<TouchPoint> Keys::next_touch() {
  const std::optional<TouchPoint> touch = std::exchange(last_touch_, std::nullopt);
  if (!touch) return std::nullopt;
  given_.touch = touch;
  given_.touch_at = clock_.now();
  return touch;
}

GivenKeys Keys::given() const {
  const std::lock_guard lock(mutex_);
  return given_;
}

std::optional<TouchPoint> Keys::read_touch() {
  take_terminal(std::chrono::milliseconds{0});
  const std::lock_guard lock(mutex_);
  take_script();
  return next_touch();
}

template <class Take>
auto Keys::wait_for(Wanted wanted, const WaitUntil& wait_until, Take take)
    -> Result<typename decltype(take())::value_type> {
  const bool is_virtual = clock_.is_virtual();
  while (true) {
    take_terminal(std::chrono::milliseconds{0});
    std::optional<Time> next;
    bool window = false;
    std::uint64_t inputs = 0;
    {
      const std::lock_guard lock(mutex_);
      take_script();
      if (auto found = take()) {
        return *found;
      }
      if (next_ < script_.size()) {
        next = script_[next_].at;
      }
      window = window_;
      inputs = inputs_;
    }
    bool typed = false;
    if (terminal_ != nullptr) {
      const std::lock_guard lock(terminal_mutex_);
      typed = terminal_->open() && (wanted != Wanted::Touch || terminal_->has_touches());
    }
    const bool person = window || typed;

    if (next && (is_virtual || !person)) {
      wait_until(*next);
    } else if (!person) {
      return fail(Errc::Unsupported,
                  std::string("waits for a ") + kNames[static_cast<std::size_t>(wanted)] +
                      " that can never come: the key script is used up, and there is no terminal "
                      "and no window; use --keys, as in --keys \"KEY1@2s,KEY4@10s\"");
    } else if (!is_virtual) {
      const Time soon = clock_.now() + kSlice;
      wait_until(next ? std::min(*next, soon) : soon);
    } else if (typed) {
      take_terminal(kSlice);
    } else {
      std::unique_lock lock(mutex_);
      // For something new: what is there already is not what is wanted.
      pressed_.wait(lock, [&] { return inputs_ != inputs || !window_; });
    }
  }
}

Result<int> Keys::wait(int mask, const WaitUntil& wait_until) {
  if ((mask & kAllKeys) == 0) {
    return fail(Errc::OutOfRange, "key mask " + std::to_string(mask) + ", expected KEY1..KEY4");
  }
  return wait_for(Wanted::Key, wait_until, [&] { return next_key(mask); });
}

Result<TouchPoint> Keys::wait_touch(const WaitUntil& wait_until) {
  return wait_for(Wanted::Touch, wait_until, [&] { return next_touch(); });
}

void Keys::press_remote(int code) {
  if (code < 1 || code > 255) {
    return;
  }
  const std::lock_guard lock(mutex_);
  remote_.push_back(code);
  ++inputs_;
  pressed_.notify_all();
}

void Keys::take_remote(int typed) {
  const std::lock_guard lock(mutex_);
  if (typed != 0 && uses_remote_) remote_.push_back(typed);
}

std::optional<int> Keys::next_remote() {
  if (remote_.empty()) return std::nullopt;
  const int code = remote_.front();
  remote_.pop_front();
  given_.remote = code;
  given_.remote_at = clock_.now();
  return code;
}

void Keys::begin_remote() {
  {
    const std::lock_guard lock(mutex_);
    uses_remote_ = true;
  }
  take_terminal(std::chrono::milliseconds{0});
}

int Keys::read_remote() {
  begin_remote();
  const std::lock_guard lock(mutex_);
  take_script();
  return next_remote().value_or(0);
}

Result<int> Keys::wait_remote(const WaitUntil& wait_until) {
  begin_remote();
  return wait_for(Wanted::Remote, wait_until, [&] { return next_remote(); });
}

void Keys::flush_remote() {
  begin_remote();
  const std::lock_guard lock(mutex_);
  take_script();
  remote_.clear();
}

}  // namespace eyebridge::robios
