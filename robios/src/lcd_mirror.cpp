#include "lcd_mirror.hpp"

#include <cstdio>

#include "lcd.hpp"

namespace eyebridge::robios {
namespace {

constexpr Time kPeriod = std::chrono::milliseconds(200);

}  // namespace

void LcdMirror::update(Time now, bool force) {
  if ((now < next_ && !force) || lcd_.revision() == revision_) return;
  next_ = now + kPeriod;
  revision_ = lcd_.revision();
  const std::vector<std::string> rows = lcd_.text_rows();
  shown_.resize(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows[row] == shown_[row]) continue;
    std::printf("lcd %2zu| %s\n", row, rows[row].c_str());
  }
  shown_ = rows;
  std::fflush(stdout);
}

}  // namespace eyebridge::robios
