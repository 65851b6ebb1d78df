#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "eyebridge/camera/frame.hpp"
#include "soft_keys.hpp"

namespace eyebridge::robios {

/// A robot's screen, as whoever looks at it sees it: a window, a terminal, a file. Programs draw by
/// the calls of the screen that their generation of RoBIOS has. Any thread.
class Screen {
 public:
  virtual ~Screen() = default;

  /// What is shown, Rgb24.
  [[nodiscard]] virtual camera::Frame snapshot() const = 0;
  /// The text on it, one string (UTF-8) a row, trailing blanks cut.
  [[nodiscard]] virtual std::vector<std::string> text_rows() const = 0;
  /// The labels of the soft keys as last set, whether or not they are shown.
  [[nodiscard]] virtual std::array<std::string, kSoftKeys> menu_labels() const = 0;
  /// Mask of the soft key under a pixel (1, 2, 4, 8), or 0.
  [[nodiscard]] virtual int key_at(int x, int y) const = 0;
  /// Counts the changes of what is shown: equal numbers, equal pictures.
  [[nodiscard]] virtual std::uint64_t revision() const = 0;
};

}  // namespace eyebridge::robios
