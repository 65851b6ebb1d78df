#include "lcd_mirror.hpp"

#include <cstdio>

#include "screen.hpp"

namespace eyebridge::robios {
namespace {

constexpr Time kPeriod = std::chrono::milliseconds(200);

}  // namespace

void LcdMirror::update(Time now, bool force) {
  if ((now < next_ && !force) || screen_.revision() == revision_) return;
  next_ = now + kPeriod;
  revision_ = screen_.revision();
  const std::vector<std::string> rows = screen_.text_rows();
  shown_.resize(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows[row] == shown_[row]) continue;
    std::printf("lcd %2zu| %s\n", row, rows[row].c_str());
  }
  shown_ = rows;
  std::fflush(stdout);
}

}  // namespace eyebridge::robios
