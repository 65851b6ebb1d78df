#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <span>

namespace eyebridge::mapping {

/// The values of a grid's cells. The system gives each page of their memory when it is first
/// written: a map of 100 x 100 m with cells of 2 cm takes 100 MB when all of it has been seen, and
/// next to nothing before. This holds for cells that begin as 0, the log-odds of the usual prior of
/// 0.5; cells with another value are written at once. A copy takes memory only for pages that are
/// not 0.
class SeenCells {
 public:
  /// Cells of a block, which is left alone as a whole: a page of memory.
  static constexpr std::size_t kBlock = 1024;

  SeenCells() = default;
  SeenCells(std::size_t size, float value);
  SeenCells(const SeenCells& other);
  SeenCells& operator=(const SeenCells& other);
  SeenCells(SeenCells&&) noexcept = default;
  SeenCells& operator=(SeenCells&&) noexcept = default;
  ~SeenCells() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] float* data() { return cells_.get(); }
  [[nodiscard]] const float* data() const { return cells_.get(); }
  [[nodiscard]] float* begin() { return data(); }
  [[nodiscard]] float* end() { return data() + size_; }
  [[nodiscard]] const float* begin() const { return data(); }
  [[nodiscard]] const float* end() const { return data() + size_; }
  [[nodiscard]] float& operator[](std::size_t index) { return cells_[index]; }
  [[nodiscard]] const float& operator[](std::size_t index) const { return cells_[index]; }

  friend bool operator==(const SeenCells& a, const SeenCells& b);

 private:
  struct Free {
    void operator()(float* cells) const { std::free(cells); }
  };
  std::size_t size_ = 0;
  std::unique_ptr<float[], Free> cells_;
};

/// Copies values to `to` where they are others than there: memory that is only read is not taken.
void copy_differing(std::span<const float> from, float* to);

/// Calls `function(std::span<float>)` for each block in which a cell is not `value`.
template <class Function>
void for_blocks_unlike(float value, std::span<float> cells, const Function& function) {
  while (!cells.empty()) {
    const std::span<float> block = cells.first(std::min(SeenCells::kBlock, cells.size()));
    if (std::ranges::count(block, value) != std::ssize(block)) function(block);
    cells = cells.subspan(block.size());
  }
}

}  // namespace eyebridge::mapping
