#pragma once

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "named_program.hpp"

namespace eyebridge::testing {

/// Settings for as many robots in worlds/rooms.wld; `more` of them.
inline std::map<std::string, std::string> several(const std::string& count,
                                                  std::map<std::string, std::string> more = {}) {
  more.emplace("EYEBRIDGE_ROBOTS", count);
  more.emplace("EYEBRIDGE_WORLD", std::string(EYEBRIDGE_TEST_WORLDS) + "/rooms.wld");
  return more;
}

inline std::vector<std::string> sorted_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  std::ranges::sort(lines);
  return lines;
}

/// "trace 0123456789abcdef" of the last message of a run; each ends with one.
inline std::string trace_of(const std::string& messages) {
  const std::size_t at = messages.find("trace ");
  EXPECT_NE(at, std::string::npos) << messages;
  return at == std::string::npos ? "" : messages.substr(at, 22);
}

}  // namespace eyebridge::testing
