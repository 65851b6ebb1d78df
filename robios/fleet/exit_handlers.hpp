#pragma once

#include <cstddef>
#include <vector>

struct link_map;

namespace eyebridge::robios {

/// What programs want to be called at their end: their atexit() functions, the destructors of their
/// static objects. The C library would call them after the whole run, in no robot. Any thread.
class ExitHandlers {
 public:
  enum class Kind { Exit, ExitWithStatus, QuickExit };

  /// To be called at the end of the image in which `address` lies; false when that is none.
  static bool add(Kind kind, void* function, void* argument, const void* address);
  /// Calls those of `image`, the last one first, also what they add meanwhile. May be called anew
  /// where one of them did not return.
  static void run(const link_map& image, bool is_quick, int status);
  /// Around fork(), whose child would find locked for ever what another thread changes.
  static void hold();
  static void release();
};

}  // namespace eyebridge::robios
