#include "workers.hpp"

#include <algorithm>
#include <utility>

namespace eyebridge::episode {
namespace {

// Shares a thread: few enough that the counter is no bottleneck, enough to even out the load.
constexpr std::size_t kSharesEach = 8;

}  // namespace

Workers::Workers(unsigned threads) {
  const unsigned all = threads == 0 ? std::max(std::thread::hardware_concurrency(), 1U) : threads;
  for (unsigned i = 1; i < all; ++i) threads_.emplace_back([this] { wait_for_work(); });
}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::for_each(std::size_t count, const std::function<void(std::size_t)>& body) {
  {
    const std::lock_guard lock(mutex_);
    body_ = &body;
    count_ = count;
    share_ = std::max(count / ((threads_.size() + 1) * kSharesEach), std::size_t{1});
    next_ = 0;
    busy_ = threads_.size();
    failure_ = nullptr;
    ++round_;
  }
  begun_.notify_all();
  take_shares();
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return busy_ == 0; });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Workers::wait_for_work() {
  std::uint64_t seen = 0;
  std::unique_lock lock(mutex_);
  for (;;) {
    begun_.wait(lock, [&] { return ending_ || round_ != seen; });
    if (ending_) return;
    seen = round_;
    lock.unlock();
    take_shares();
    lock.lock();
    if (--busy_ == 0) done_.notify_one();
  }
}

void Workers::take_shares() {
  for (;;) {
    const std::size_t first = next_.fetch_add(share_);
    if (first >= count_) return;
    const std::size_t end = std::min(first + share_, count_);
    for (std::size_t i = first; i < end; ++i) {
      try {
        (*body_)(i);
      } catch (...) {
        note_failure(i);
      }
    }
  }
}

void Workers::note_failure(std::size_t index) {
  const std::lock_guard lock(mutex_);
  if (failure_ && failed_index_ < index) return;
  failure_ = std::current_exception();
  failed_index_ = index;
}

}  // namespace eyebridge::episode
