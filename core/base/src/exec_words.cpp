#include "eyebridge/base/exec_words.hpp"

#include <cstring>
#include <string_view>

#include <unistd.h>

namespace eyebridge {

std::vector<std::string> environment_with(const std::map<std::string, std::string>& changes) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::string name(text.substr(0, text.find('=')));
    if (!changes.contains(name)) all.emplace_back(text);
  }
  for (const auto& [name, value] : changes) all.push_back(name + "=" + value);
  return all;
}

std::vector<char*> pointers_to(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  // The system does not write to them; its interface is older than const.
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

void execute(char* const* words, char* const* environment) {
  // Not execvpe() for a path: it would hand what the kernel refuses to sh.
  if (std::strchr(words[0], '/') == nullptr) {
    execvpe(words[0], words, environment);
  } else {
    execve(words[0], words, environment);
  }
}

}  // namespace eyebridge
