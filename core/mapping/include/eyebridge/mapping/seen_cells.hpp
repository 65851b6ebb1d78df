#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <span>

namespace eyebridge::mapping {

/// The values of a grid's cells, in memory that the system gives when a page of it is first
/// written: a map of 100 x 100 m with cells of 2 cm takes 100 MB when all of it has been seen, and
/// next to nothing at the start. That holds for cells that begin as 0, which is the log-odds of the
/// usual prior of 0.5; others are written at once. Copies take what is not 0.
class SeenCells {
 public:
  /// Cells that are looked at together: a page of memory.
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

/// Copies `from`, but for blocks that are 0, to `to`, which is 0.
void copy_seen(std::span<const float> from, float* to);

/// Whether all of them are 0, and not -0.
bool are_unseen(std::span<const float> cells);

/// Calls `function(std::span<float>)` for one block of `cells` after the other, but for those that
/// are 0: what is only read takes no memory.
template <class Function>
void for_each_seen(std::span<float> cells, const Function& function) {
  while (!cells.empty()) {
    const std::span<float> block = cells.first(std::min(SeenCells::kBlock, cells.size()));
    if (!are_unseen(block)) function(block);
    cells = cells.subspan(block.size());
  }
}

}  // namespace eyebridge::mapping
