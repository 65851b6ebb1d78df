#pragma once

#include <map>
#include <string>

#include "text.hpp"

namespace eyebridge::files {

/// What a reader does not carry over: counted by kind, said once a kind, at its first place.
class LeftOut {
 public:
  void add(const SourceLocation& where, const std::string& what) {
    Kind& kind = kinds_[what];
    if (kind.count++ == 0) kind.where = where;
  }
  void say(Warnings& warnings) const {
    for (const auto& [what, kind] : kinds_) {
      warnings.add(kind.where.line, kind.where.column,
                   "not carried over: " + what +
                       (kind.count == 1 ? "" : " (" + std::to_string(kind.count) + " times)"));
    }
  }

 private:
  struct Kind {
    int count = 0;
    SourceLocation where;
  };
  std::map<std::string, Kind> kinds_;
};

}  // namespace eyebridge::files
