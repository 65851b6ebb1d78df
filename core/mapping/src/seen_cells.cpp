#include "eyebridge/mapping/seen_cells.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>

namespace eyebridge::mapping {

SeenCells::SeenCells(std::size_t size, float value) : size_(size) {
  if (size == 0) return;
  // Large ones are pages of the system's that nobody has touched.
  cells_.reset(static_cast<float*>(std::calloc(size, sizeof(float))));
  if (cells_ == nullptr) throw std::bad_alloc();
  if (!are_unseen({&value, 1})) std::fill_n(cells_.get(), size, value);
}

SeenCells::SeenCells(const SeenCells& other) : SeenCells(other.size_, 0.0F) {
  copy_seen({other.data(), other.size_}, data());
}

SeenCells& SeenCells::operator=(const SeenCells& other) {
  if (this != &other) *this = SeenCells(other);
  return *this;
}

bool operator==(const SeenCells& a, const SeenCells& b) { return std::ranges::equal(a, b); }

void copy_seen(std::span<const float> from, float* to) {
  while (!from.empty()) {
    const auto block = from.first(std::min(SeenCells::kBlock, from.size()));
    if (!are_unseen(block)) std::ranges::copy(block, to);
    to += block.size();
    from = from.subspan(block.size());
  }
}

bool are_unseen(std::span<const float> cells) {
  static constexpr std::array<float, SeenCells::kBlock> kUnseen{};
  while (!cells.empty()) {
    const auto block = cells.first(std::min(kUnseen.size(), cells.size()));
    if (std::memcmp(block.data(), kUnseen.data(), block.size_bytes()) != 0) return false;
    cells = cells.subspan(block.size());
  }
  return true;
}

}  // namespace eyebridge::mapping
