#pragma once

#include <functional>
#include <thread>

namespace eyebridge {

/// A thread that takes no signal, and whose own threads take none: handlers of a robot program run
/// on the program's threads, and threads that take none keep no process alive whose program left.
/// Any thread.
std::thread deaf_thread(std::function<void()> body);

}  // namespace eyebridge
