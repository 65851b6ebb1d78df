// Threads that wait for each other in the ways of C++20; the driver of the run sees that time
// passes for all of them at once.
#include <barrier>
#include <chrono>
#include <cstdio>
#include <future>
#include <latch>
#include <mutex>
#include <semaphore>
#include <shared_mutex>
#include <thread>

#include <eyebot++.h>

using namespace std::chrono_literals;

namespace {

int tens() { return OSGetCount() / 10 * 10; }

void await_a_future() {
  std::future<int> answer = std::async(std::launch::async, [] {
    OSWait(500);
    return 7;
  });
  int looks = 0;
  while (answer.wait_for(100ms) != std::future_status::ready) ++looks;
  std::printf("future %d at %d, looked %d times\n", answer.get(), tens(), looks);
}

template <class Meeting>
void meet(const char* name) {
  Meeting meeting(3);
  const int start = OSGetCount();
  std::thread first([&] {
    OSWait(10);
    meeting.arrive_and_wait();
  });
  std::thread second([&] {
    OSWait(30);
    meeting.arrive_and_wait();
  });
  meeting.arrive_and_wait();
  std::printf("%s after %d\n", name, (OSGetCount() - start) / 10 * 10);
  first.join();
  second.join();
}

void take_what_is_given() {
  std::counting_semaphore<5> given(0);
  std::thread giver([&] {
    OSWait(300);
    given.release(2);
  });
  const int start = OSGetCount();
  const bool early = given.try_acquire_for(100ms);
  const int tried = OSGetCount() - start;
  given.acquire();
  given.acquire();
  std::printf("semaphore %d after %d, then after %d\n", early, tried / 10 * 10,
              (OSGetCount() - start) / 10 * 10);
  giver.join();
}

template <class Mutex>
void lock_late(const char* name) {
  Mutex mutex;
  mutex.lock();
  const int start = OSGetCount();
  std::thread other([&] {
    const bool early = mutex.try_lock_for(50ms);
    const int tried = OSGetCount() - start;
    mutex.lock();
    std::printf("%s %d after %d, then after %d\n", name, early, tried / 10 * 10,
                (OSGetCount() - start) / 10 * 10);
    mutex.unlock();
  });
  OSWait(200);
  mutex.unlock();
  other.join();
}

void read_late() {
  std::shared_timed_mutex mutex;
  mutex.lock();
  const int start = OSGetCount();
  std::thread reader([&] {
    const bool early = mutex.try_lock_shared_for(50ms);
    mutex.lock_shared();
    std::printf("reader %d, then after %d\n", early, (OSGetCount() - start) / 10 * 10);
    mutex.unlock_shared();
  });
  OSWait(200);
  mutex.unlock();
  reader.join();
}

}  // namespace

int main() {
  OSGetCount();
  await_a_future();
  meet<std::latch>("latch");
  meet<std::barrier<>>("barrier");
  take_what_is_given();
  lock_late<std::timed_mutex>("mutex");
  lock_late<std::shared_timed_mutex>("writer");
  read_late();
  std::printf("all at %d\n", tens());
}
