#pragma once

#include <compare>
#include <vector>

#include "eyebridge/world/world.hpp"

namespace eyebridge::world {

/// Who touches whom, so that each contact is told of once, when it begins.
///
/// A contact lasts until the two are kReleaseGap apart; all walls count as one.
class ContactBook {
 public:
  /// A body that leaves what it touched by less than this, metres, still touches it: what bounces
  /// or is pushed in steps leaves by a little again and again.
  static constexpr double kReleaseGap = 1e-3;

  /// `bump.body` ran into `bump.other` in this step; told of unless they touch already.
  void note(const Bump& bump);

  /// Ends a step: forgets the pairs for which gap(body, other) > kReleaseGap, save those that were
  /// noted in this step; calls ended(body, other) for each. `other` is kNoBody for the walls.
  template <class Gap, class Ended>
  void end_step(Gap gap, Ended ended) {
    begun_.swap(coming_);
    coming_.clear();
    std::erase_if(pairs_, [&](Pair& pair) {
      const bool noted = pair.noted;
      pair.noted = false;
      if (noted || gap(pair.a, pair.b) <= kReleaseGap) return false;
      ended(pair.a, pair.b);
      return true;
    });
  }

  /// Forgets the contacts of `body`, which a person put somewhere else; as end_step().
  template <class Ended>
  void forget(BodyId body, Ended ended) {
    std::erase_if(pairs_, [&](const Pair& pair) {
      if (pair.a != body && pair.b != body) return false;
      ended(pair.a, pair.b);
      return true;
    });
  }

  /// Those that began in the last step that was ended.
  [[nodiscard]] const std::vector<Bump>& begun() const { return begun_; }

 private:
  struct Pair {
    BodyId a;  ///< The lower id.
    BodyId b;  ///< kNoBody: the walls.
    bool noted = true;
  };

  std::vector<Pair> pairs_;  ///< Sorted by a, then b.
  std::vector<Bump> coming_;
  std::vector<Bump> begun_;
};

}  // namespace eyebridge::world
