#include "soft_keys.hpp"

#include <algorithm>

#include "utf8.hpp"

namespace eyebridge::robios {
namespace {

constexpr std::array<Rgb, kSoftKeys> kPapers{
    {{255, 0, 0}, {0, 255, 0}, {255, 255, 0}, {0, 0, 255}}};  // red, green, yellow, blue
constexpr Rgb kBlack{};

std::string cut(std::string_view label) { return std::string(label.substr(0, kLabelBytes)); }

}  // namespace

SoftKeys::SoftKeys(int width) : width_(width) { set_all({}); }

void SoftKeys::set_all(const std::array<std::string_view, kSoftKeys>& labels) {
  for (std::size_t key = 0; key < keys_.size(); ++key) {
    keys_[key] = {cut(labels[key]), kBlack, kPapers[key]};
  }
  counts_from_zero_ = false;
  picture_.reset();
}

Result<void> SoftKeys::set_one(int position, std::string_view label, Rgb ink, Rgb paper) {
  const bool from_zero = counts_from_zero_ || position == 0;
  const int first = from_zero ? 0 : 1;
  if (position < first || position >= first + kSoftKeys) {
    return fail(Errc::OutOfRange, "menu position " + std::to_string(position) + ", expected " +
                                      (from_zero ? "0..3" : "1..4"));
  }
  counts_from_zero_ = from_zero;
  keys_[static_cast<std::size_t>(position - first)] = {cut(label), ink, paper};
  picture_.reset();
  return {};
}

int SoftKeys::left_of(int key) const { return width_ * key / kSoftKeys; }

int SoftKeys::key_at(int x) const {
  for (int key = 0; key < kSoftKeys; ++key) {
    if (x >= left_of(key) && x < left_of(key + 1)) {
      return 1 << key;
    }
  }
  return 0;
}

const Canvas& SoftKeys::picture() const {
  if (!picture_) paint(picture_.emplace(width_, kMenuHeight));
  return *picture_;
}

void SoftKeys::paint(Canvas& picture) const {
  const Font font(FontFamily::Helvetica, FontStyle::Bold, 12);
  for (int key = 0; key < kSoftKeys; ++key) {
    const SoftKeyLook& look = keys_[static_cast<std::size_t>(key)];
    const int left = left_of(key);
    const int right = left_of(key + 1) - 1;
    picture.area(left, 0, right, kMenuHeight - 1, look.paper, true);

    const std::vector<std::string> lines = latin1_lines(look.label);
    const int columns = (right - left - 1) / font.cell_width();
    int y = (kMenuHeight - static_cast<int>(lines.size()) * font.cell_height()) / 2;
    for (const std::string& line : lines) {
      const int length = std::min(static_cast<int>(line.size()), columns);
      int x = left + (right - left + 1 - length * font.cell_width()) / 2;
      for (const char c : line.substr(0, static_cast<std::size_t>(length))) {
        picture.glyph(x, y, font, static_cast<std::uint8_t>(c), look.ink, look.paper);
        x += font.cell_width();
      }
      y += font.cell_height();
    }
    picture.area(left, 0, right, kMenuHeight - 1, kBlack, false);
  }
}

}  // namespace eyebridge::robios
