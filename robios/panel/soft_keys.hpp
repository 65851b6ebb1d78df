#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "canvas.hpp"
#include "eyebridge/base/result.hpp"

namespace eyebridge::robios {

inline constexpr int kSoftKeys = 4;
/// Height of the strip of soft keys, pixels (MENU_HEIGHT).
inline constexpr int kMenuHeight = 38;
/// Bytes of a label that count (LCD_MENU_STRLENGTH less the closing zero).
inline constexpr std::size_t kLabelBytes = 31;

/// How one of them looks.
struct SoftKeyLook {
  std::string label;  ///< '\n' separates lines.
  Rgb ink;
  Rgb paper;

  friend bool operator==(const SoftKeyLook&, const SoftKeyLook&) = default;
};

/// The four labelled keys along the lower edge of the screen. One thread.
class SoftKeys {
 public:
  explicit SoftKeys(int width);

  /// New labels in the usual colours; cut to kLabelBytes. '\n' separates lines.
  void set_all(const std::array<std::string_view, kSoftKeys>& labels);
  /// One label in its own colours. Positions count from 1 until a 0 is given, then from 0 until
  /// set_all(): programs of both kinds exist. OutOfRange otherwise.
  Result<void> set_one(int position, std::string_view label, Rgb ink, Rgb paper);

  /// Mask of the key at column x of the strip.
  [[nodiscard]] int key_at(int x) const;
  /// The strip as it looks: the screen's width x kMenuHeight.
  /// Made when somebody first looks, and valid until a label changes: of a thousand robots few have
  /// labels.
  [[nodiscard]] const Canvas& picture() const;
  /// Of key 0..3.
  [[nodiscard]] const SoftKeyLook& look(std::size_t key) const { return keys_.at(key); }

 private:
  [[nodiscard]] int left_of(int key) const;
  void paint(Canvas& picture) const;

  int width_;
  std::array<SoftKeyLook, kSoftKeys> keys_;
  bool counts_from_zero_ = false;
  mutable std::optional<Canvas> picture_;  ///< Without a value when the labels have changed.
};

}  // namespace eyebridge::robios
