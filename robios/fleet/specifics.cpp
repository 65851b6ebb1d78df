#include "specifics.hpp"

#include <climits>
#include <utility>

namespace eyebridge::robios {

void Specifics::make(unsigned key, Destroy destroyer) {
  keys_[key] = {lockstep_.current()->robot, destroyer};
}

void Specifics::forget(unsigned key) {
  keys_.erase(key);
  std::erase_if(values_, [key](const auto& row) { return row.first.second == key; });
}

void* Specifics::get(unsigned key) const {
  const auto found = values_.find({lockstep_.current(), key});
  return found == values_.end() ? nullptr : found->second;
}

void Specifics::set(unsigned key, const void* value) {
  values_[{lockstep_.current(), key}] = const_cast<void*>(value);  // as in POSIX
}

void Specifics::destroy() {
  const Strand* const me = lockstep_.current();
  const auto first = [&] { return values_.lower_bound({me, 0}); };
  const auto is_mine = [&](auto row) { return row != values_.end() && row->first.first == me; };
  // A destructor may set values again: so often is asked, as in the C library.
  for (int round = 0; round < PTHREAD_DESTRUCTOR_ITERATIONS && is_mine(first()); ++round) {
    std::map<unsigned, void*> mine;
    while (is_mine(first())) {
      mine[first()->first.second] = first()->second;
      values_.erase(first());
    }
    for (const auto& [key, value] : mine) {
      const auto known = keys_.find(key);
      if (value == nullptr || known == keys_.end() || known->second.destroyer == nullptr) continue;
      known->second.destroyer(value);
    }
  }
  forget_strand(me);
}

void Specifics::forget_strand(const Strand* strand) {
  std::erase_if(values_, [strand](const auto& row) { return row.first.first == strand; });
}

void Specifics::forget_robot(std::size_t robot) {
  std::erase_if(values_, [&](const auto& row) { return row.first.first->robot == robot; });
  std::erase_if(keys_, [&](const auto& row) { return row.second.robot == robot; });
}

}  // namespace eyebridge::robios
