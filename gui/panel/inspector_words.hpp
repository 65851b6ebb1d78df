#pragma once

#include <QString>
#include <string>
#include <vector>

#include "eyebridge/hal/device_notes.hpp"

namespace eyebridge::gui {

/// One number of a quantity, as people read it.
struct ShownPart {
  QString name;  ///< "heading"
  QString unit;  ///< "°"; may be empty.
};

/// What is shown of a quantity: as many as its numbers that count.
std::vector<ShownPart> parts_of(hal::Quantity quantity);
/// The number of that part in its unit.
QString part_text(hal::Quantity quantity, std::size_t part, const hal::NoteCell::Values& values);
/// Above all devices of a kind: "Distance sensors".
QString title_of(const std::string& kind);
/// "PSD_FRONT (1)", "2", "line 3".
QString name_of(const hal::NotedValue& value);
/// Whether the row is there before the program has used it: what a device is for.
bool is_main(const hal::NotedValue& value);

}  // namespace eyebridge::gui
