#pragma once

#include <cstddef>
#include <map>
#include <utility>

#include "lockstep.hpp"

namespace eyebridge::robios {

/// What programs keep for each of their threads (pthread_setspecific), where those are strands. One
/// thread of the process; functions without a strand are called by strands.
class Specifics {
 public:
  using Strand = Lockstep::Strand;
  using Destroy = void (*)(void*);

  /// `lockstep` is lent.
  explicit Specifics(Lockstep& lockstep) : lockstep_(lockstep) {}

  /// `destroyer` may be null.
  void make(unsigned key, Destroy destroyer);
  void forget(unsigned key);
  [[nodiscard]] void* get(unsigned key) const;
  void set(unsigned key, const void* value);

  /// The calling strand ends: what has to be is destroyed, which may set other values.
  void destroy();
  /// Forgets what a strand had that is ended from outside, or
  void forget_strand(const Strand* strand);
  /// what a robot that has ended had.
  void forget_robot(std::size_t robot);

 private:
  struct Key {
    std::size_t robot = 0;  ///< Whose program made it.
    Destroy destroyer = nullptr;
  };

  Lockstep& lockstep_;
  std::map<unsigned, Key> keys_;
  std::map<std::pair<const Strand*, unsigned>, void*> values_;
};

}  // namespace eyebridge::robios
