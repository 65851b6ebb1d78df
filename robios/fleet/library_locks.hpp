#pragma once

#include <cstddef>

namespace eyebridge::robios {

/// What the C library has locked for a flow of a program that ends in the middle of it. For that
/// flow's thread; nothing here takes memory.
namespace library_locks {

/// Gives back standard input, output and error where the calling thread has them.
void release_streams();

/// Starts the thread that tries locks. Once, before any thread may need it.
void begin();

/// While it lives the heap of the thread that made it is one of those that are tried.
class HeapInUse {
 public:
  HeapInUse();
  ~HeapInUse();
  HeapInUse(const HeapInUse&) = delete;
  HeapInUse& operator=(const HeapInUse&) = delete;

 private:
  std::size_t place_ = 0;
};

/// True when others can go on: memory can be taken and given back, and in real time, where
/// `others_are_threads`, files opened and programs loaded.
[[nodiscard]] bool are_free(bool others_are_threads);

/// True while somebody waits for are_free(), or has heard that they are not. Any thread.
[[nodiscard]] bool are_in_doubt();

/// For the handler of a crash: does not return where the thread that tries locks has crashed, over
/// what a program wrote where it has no memory. are_free() is false then.
void end_trial();

}  // namespace library_locks
}  // namespace eyebridge::robios
