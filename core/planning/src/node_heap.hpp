#pragma once

#include <cassert>
#include <cstddef>
#include <limits>
#include <vector>

#include "grid_graph.hpp"

namespace eyebridge::planning {

/// A binary heap of nodes whose keys may change while they are in it: two arrays, no allocation for
/// a node. Of equal keys the smaller node comes first.
template <class Key>
class NodeHeap {
 public:
  struct Entry {
    Key key;
    Node node;
  };

  /// For nodes below `nodes`.
  explicit NodeHeap(std::size_t nodes) : places_(nodes, kNowhere) {}

  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] const Entry& top() const {
    assert(!empty());
    return entries_.front();
  }
  /// Puts `node` in, or gives it another key.
  void set(Node node, const Key& key) {
    std::size_t place = places_[node];
    if (place == kNowhere) {
      place = entries_.size();
      entries_.push_back({key, node});
      rise(place, {key, node});
    } else {
      settle(place, {key, node});
    }
  }
  /// Takes `node` out if it is in.
  void remove(Node node) {
    const std::size_t place = places_[node];
    if (place == kNowhere) return;
    const Entry last = entries_.back();
    entries_.pop_back();
    places_[node] = kNowhere;
    if (last.node != node) settle(place, last);
  }

 private:
  static constexpr Node kNowhere = std::numeric_limits<Node>::max();

  static bool before(const Entry& a, const Entry& b) {
    if (a.key == b.key) return a.node < b.node;
    return a.key < b.key;
  }
  void put(std::size_t place, const Entry& entry) {
    entries_[place] = entry;
    places_[entry.node] = static_cast<Node>(place);
  }
  void settle(std::size_t place, const Entry& entry) {
    if (place > 0 && before(entry, entries_[(place - 1) / 2])) {
      rise(place, entry);
    } else {
      sink(place, entry);
    }
  }
  void rise(std::size_t place, const Entry& entry) {
    while (place > 0 && before(entry, entries_[(place - 1) / 2])) {
      put(place, entries_[(place - 1) / 2]);
      place = (place - 1) / 2;
    }
    put(place, entry);
  }
  void sink(std::size_t place, const Entry& entry) {
    for (std::size_t child = 2 * place + 1; child < entries_.size(); child = 2 * place + 1) {
      if (child + 1 < entries_.size() && before(entries_[child + 1], entries_[child])) ++child;
      if (!before(entries_[child], entry)) break;
      put(place, entries_[child]);
      place = child;
    }
    put(place, entry);
  }

  std::vector<Entry> entries_;
  std::vector<Node> places_;
};

}  // namespace eyebridge::planning
