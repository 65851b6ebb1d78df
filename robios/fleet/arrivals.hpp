#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <future>
#include <mutex>
#include <utility>
#include <vector>

#include "eyebridge/base/result.hpp"

namespace eyebridge::robios {

/// Robots that other threads want in a world of virtual time, or out of it, until that is done
/// between two rounds.
class Arrivals {
 public:
  using Answer = Result<std::size_t>;
  /// Lets a robot in or out: its index.
  using Act = std::function<Answer()>;

  /// What `act` says, which is called between two rounds. Any thread but that of the rounds.
  Answer ask(Act act) {
    std::future<Answer> answer;
    {
      const std::lock_guard lock(mutex_);
      if (is_closed_) return too_late();
      Request& request = waiting_.emplace_back(Request{std::move(act), {}});
      answer = request.answer.get_future();
      any_.store(true, std::memory_order_relaxed);
    }
    return answer.get();
  }

  /// Does what was asked for, in that order.
  void serve() {
    if (!any_.load(std::memory_order_relaxed)) return;
    for (Request& request : taken()) request.answer.set_value(request.act());
  }

  /// The last robot has ended: nobody is let in any more.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      is_closed_ = true;
    }
    for (Request& request : taken()) request.answer.set_value(too_late());
  }

  static Answer too_late() { return fail(Errc::Disconnected, "the run has ended"); }

 private:
  struct Request {
    Act act;
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
