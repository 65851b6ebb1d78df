#pragma once

#include <span>
#include <string_view>

namespace eyebridge::gui {

/// Which of the interfaces a program is written against.
enum class Api { Robios7, Classic, Python };

/// A name that the editor offers. Texts are UTF-8 and live as long as the process.
struct Completion {
  enum class Kind { Function, Constant, Variable, Type };
  Kind kind;
  const char* name;
  const char* prototype;  ///< With result and arguments; of a constant its value where it is known.
  const char* doc;  ///< One sentence, in lines of at most 88 characters; "" when there is none.
};

/// All names of an interface, in alphabetic order: made from the headers and from the stub of `eye`
/// while building (generate_completions.py). Any thread.
std::span<const Completion> completions(Api api);

/// The one of this name; null when there is none.
const Completion* find_completion(Api api, std::string_view name);

/// Whether a C or C++ program is one of classic RoBIOS, which has the same `eyebot.h` by name: it
/// includes one of the headers that only classic RoBIOS has, or calls more functions that only
/// classic RoBIOS has than functions that only RoBIOS-7 has. Comments and strings do not count.
bool is_classic(std::string_view program);

}  // namespace eyebridge::gui
