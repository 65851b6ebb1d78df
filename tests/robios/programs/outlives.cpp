// A thread that is there before main() and ends after it, and thread-local variables that wait when
// their thread has ended.
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <thread>

#include <poll.h>
#include <unistd.h>

#include <eyebot++.h>

namespace {

class Worker {
 public:
  ~Worker() {
    {
      const std::lock_guard lock(mutex_);
      stops_ = true;
    }
    changed_.notify_all();
    thread_.join();
    std::printf("joined, %d left\n", jobs_);
  }
  void add_job() {
    {
      const std::lock_guard lock(mutex_);
      ++jobs_;
    }
    changed_.notify_one();
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    while (!stops_) {
      changed_.wait(lock, [this] { return stops_ || jobs_ > 0; });
      if (jobs_ > 0) --jobs_;
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool stops_ = false;
  int jobs_ = 0;
  std::thread thread_{[this] { run(); }};
};

Worker worker;

struct AtEnd {
  ~AtEnd() { usleep(10'000); }
};
thread_local const AtEnd at_end;

}  // namespace

int main() {
  OSGetCount();
  for (int i = 0; i < 3; ++i) {
    worker.add_job();
    OSWait(100);
  }
  for (int i = 0; i < 20; ++i) {
    std::thread([] {
      (void)&at_end;
      OSWait(5);
    }).join();
  }
  std::printf("at %d\n", OSGetCount());
  int ends[2];
  if (pipe(ends) != 0) return 1;
  std::thread writer([&] {
    OSWait(50);
    if (write(ends[1], "x", 1) != 1) std::puts("no pipe");
  });
  pollfd file{ends[0], POLLIN, 0};
  const int early = poll(&file, 1, 20);
  const int start = OSGetCount();
  const int seen = poll(&file, 1, 1000);
  std::printf("polled %d, then %d after %d\n", early, seen, (OSGetCount() - start) / 10 * 10);
  writer.join();
}
