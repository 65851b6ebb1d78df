#include "config/entries.hpp"

#include <algorithm>

#include "eyebridge/base/text.hpp"

namespace eyebridge::hal {

std::vector<Entry> split_entries(std::string_view text, const SourceLocation& where) {
  std::vector<Entry> entries;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::string_view entry = text.substr(begin, end - begin);
    if (!trimmed(entry).empty()) {
      entries.push_back({trimmed(entry), where});
      if (where.line == 0) {
        entries.back().where.line = 1;
        entries.back().where.column = static_cast<int>(begin + entry.find_first_not_of(" \t")) + 1;
      }
    }
    begin = end + 1;
  }
  return entries;
}

}  // namespace eyebridge::hal
