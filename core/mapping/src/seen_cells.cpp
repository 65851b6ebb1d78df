#include "eyebridge/mapping/seen_cells.hpp"

#include <algorithm>
#include <new>

namespace eyebridge::mapping {

SeenCells::SeenCells(std::size_t size, float value) : size_(size) {
  if (size == 0) return;
  // Many at once are pages that the system has not given yet.
  cells_.reset(static_cast<float*>(std::calloc(size, sizeof(float))));
  if (cells_ == nullptr) throw std::bad_alloc();
  if (value != 0.0F) std::ranges::fill(*this, value);
}

SeenCells::SeenCells(const SeenCells& other) : SeenCells(other.size_, 0.0F) {
  copy_differing(other, data());
}

SeenCells& SeenCells::operator=(const SeenCells& other) {
  if (this != &other) *this = SeenCells(other);
  return *this;
}

bool operator==(const SeenCells& a, const SeenCells& b) { return std::ranges::equal(a, b); }

void copy_differing(std::span<const float> from, float* to) {
  while (!from.empty()) {
    const auto block = from.first(std::min(SeenCells::kBlock, from.size()));
    if (!std::equal(block.begin(), block.end(), to)) std::ranges::copy(block, to);
    to += block.size();
    from = from.subspan(block.size());
  }
}

}  // namespace eyebridge::mapping
