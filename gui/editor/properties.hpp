#pragma once

#include <QString>
#include <QStringList>
#include <QVariant>
#include <functional>
#include <vector>

#include "editor/catalogue.hpp"
#include "editor/plan.hpp"

namespace eyebridge::gui {

/// One thing that can be said of what is selected, or of the floor: a row of the panel.
struct Property {
  enum class Type { Number, Flag, Text, Choice, Colour };

  QString name;
  Type type = Type::Number;
  QString unit;       ///< Of a number, as it is shown.
  double low = 0.0;   ///< In that unit.
  double high = 0.0;  ///< In that unit.
  int decimals = 1;
  QString none;         ///< What a number at `low` says instead, where it may be left open.
  QStringList choices;  ///< Of a choice; it may be typed, too.
  /// In that unit; invalid where `item` has no such property. The floor's has an item of no
  /// meaning.
  std::function<QVariant(const Plan&, const Item&)> get;
  std::function<void(Plan&, const Item&, const QVariant&)> set;
};

/// Of the floor, shown while nothing is selected.
std::vector<Property> floor_properties();
/// Of elements of one kind.
std::vector<Property> properties_of(Kind kind, const Catalogue& catalogue);
/// What a kind is called.
QString name_of(Kind kind);

}  // namespace eyebridge::gui
