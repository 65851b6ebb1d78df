#include "scan_notes.hpp"

namespace eyebridge::mapping {

int ScanNotes::stride_of(int columns) {
  constexpr int kWord = PolygonFill::kBits;
  // An odd number of words: at a power of two, the cells above each other would fight for the same
  // lines of the cache.
  return (((columns + kWord - 1) / kWord) | 1) * kWord;
}

void ScanNotes::begin(const Box& box) {
  box_ = box;
  if (said_.size() <= box.size()) {
    said_.resize(box.size() + 1, kNoEvidence);
    told_.resize(box.size() / kTile + 1, 0);
  }
}

void ScanNotes::apply(OccupancyGrid& grid, Cell corner, PolygonFill& fill, float filled) {
  const TiledRows rows{box_, said_.data(), told_.data(),
                       grid.edit() + grid.geometry().index_of(corner),
                       static_cast<std::size_t>(grid.geometry().columns)};
  add_evidence(rows, fill, filled, {grid.lowest(), grid.highest()});
  said_[box_.size()] = kNoEvidence;  // of what lay outside
  told_[box_.size() / kTile] = 0;
}

}  // namespace eyebridge::mapping
