#pragma once

#include <atomic>
#include <cstddef>
#include <future>
#include <mutex>
#include <utility>
#include <vector>

#include "eyebridge/hal/shared_world.hpp"

namespace eyebridge::robios {

/// Robots that other threads want in a world of virtual time, until they are let in between two
/// rounds.
class Arrivals {
 public:
  using Answer = Result<std::size_t>;

  /// The index of `newcomer`, once it is in the world. Any thread but that of the rounds.
  Answer ask(hal::Newcomer newcomer) {
    std::future<Answer> answer;
    {
      const std::lock_guard lock(mutex_);
      if (is_closed_) return too_late();
      Request& request = waiting_.emplace_back(Request{std::move(newcomer), {}});
      answer = request.answer.get_future();
      any_.store(true, std::memory_order_relaxed);
    }
    return answer.get();
  }

  /// Lets in those who ask, by enter(newcomer), in the order in which they came.
  template <class Enter>
  void serve(Enter enter) {
    if (!any_.load(std::memory_order_relaxed)) return;
    for (Request& request : taken()) request.answer.set_value(enter(request.newcomer));
  }

  /// The last robot has ended: nobody is let in any more.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      is_closed_ = true;
    }
    serve([](const hal::Newcomer&) { return too_late(); });
  }

  static Answer too_late() { return fail(Errc::Disconnected, "the run has ended"); }

 private:
  struct Request {
    hal::Newcomer newcomer;
    std::promise<Answer> answer;
  };

  std::vector<Request> taken() {
    const std::lock_guard lock(mutex_);
    any_.store(false, std::memory_order_relaxed);
    return std::exchange(waiting_, {});
  }

  std::mutex mutex_;
  std::vector<Request> waiting_;
  bool is_closed_ = false;
  std::atomic<bool> any_ = false;
};

}  // namespace eyebridge::robios
