#pragma once

#include <span>

namespace eyebridge {

/// Starts a process that can outlive this one: a copy of the calling thread that runs
/// `body(argument)` and must not return from it.
///
/// It has the descriptors of `keep` as 0, 1, …, all others closed; a session of its own, so that
/// neither Ctrl-C nor a hang-up of the terminal reaches it; all signals blocked; and the name
/// `name` (15 characters). The program neither hears of its end nor finds it by wait(). A program
/// may have many threads, whose locks the copy can never take: `body` uses system calls only.
/// Returns false, with errno, when the system gives no process. Any thread.
bool start_hidden_process(const char* name, std::span<const int> keep,
                          void (*body)(const void* argument), const void* argument) noexcept;

}  // namespace eyebridge
