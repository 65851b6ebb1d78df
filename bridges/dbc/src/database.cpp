#include "eyebridge/bridges/dbc/database.hpp"

namespace eyebridge::bridges::dbc {
namespace {

template <class Entry>
const Entry* only_one(const std::vector<Entry>& entries, std::string_view name) {
  const Entry* found = nullptr;
  for (const Entry& entry : entries) {
    if (entry.name != name) continue;
    if (found != nullptr) return nullptr;
    found = &entry;
  }
  return found;
}

}  // namespace

const Signal* Message::find(std::string_view wanted) const { return only_one(signals, wanted); }
const Message* Database::find(std::string_view wanted) const { return only_one(messages, wanted); }

}  // namespace eyebridge::bridges::dbc
