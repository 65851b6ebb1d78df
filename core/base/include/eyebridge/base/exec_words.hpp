#pragma once

#include <map>
#include <string>
#include <vector>

namespace eyebridge {

/// The environment of this process as "NAME=VALUE"; `changes` replaces or adds variables.
std::vector<std::string> environment_with(const std::map<std::string, std::string>& changes);

/// The array that execve() and posix_spawn() take: pointers into `words`, which must outlive it,
/// then null.
std::vector<char*> pointers_to(const std::vector<std::string>& words);

/// Becomes the program words[0], a path or a name in PATH. Returns only when the system refuses,
/// with errno. System calls only: for the child of a fork(), too.
void execute(char* const* words, char* const* environment);

}  // namespace eyebridge
