#pragma once

#include <QColor>
#include <QCoreApplication>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "editor/properties.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {

// What the sources of properties share; nobody else includes this.

/// Makes the rows of each kind.
class Rows {
  Q_DECLARE_TR_FUNCTIONS(Properties)

 public:
  static std::vector<Property> floor();
  static std::vector<Property> wall();
  static std::vector<Property> marker();
  static std::vector<Property> start();
  static std::vector<Property> thing();
  static std::vector<Property> robot(const Catalogue& catalogue);
  static QString name(Kind kind);

 private:
  static void add_pose(std::vector<Property>& rows, bool with_heading);
  static void add_matter(std::vector<Property>& rows);
  static void add_way(std::vector<Property>& rows);
  static Property corners();
};

/// What a Property asks and does.
using Get = std::function<QVariant(const Plan&, const Item&)>;
using Set = std::function<void(Plan&, const Item&, const QVariant&)>;

inline constexpr double kFarthest_mm = 1e7;  // as files may say
inline constexpr double kOpen = -1.0;        // a number that is left open

/// A number in `unit`.
inline Property number(const QString& name, const QString& unit, double low, double high,
                       int decimals, Get get, Set set) {
  return {name, Property::Type::Number, unit,          low, high, decimals, {},
          {},   std::move(get),         std::move(set)};
}
/// All else.
inline Property other(const QString& name, Property::Type type, Get get, Set set) {
  return {name, type, {}, 0, 0, 0, {}, {}, std::move(get), std::move(set)};
}

/// A length of the element that `of` finds.
template <class Of>
Property length(const QString& name, double low, double high, Of of) {
  return number(
      name, "mm", low, high, 1,
      [of](const Plan& plan, const Item& item) {
        return m_to_mm(of(const_cast<Plan&>(plan), item));
      },
      [of](Plan& plan, const Item& item, const QVariant& value) {
        of(plan, item) = mm_to_m(value.toDouble());
      });
}

/// A colour of the element that `of` finds.
template <class Of>
Property colour(const QString& name, Of of) {
  return other(
      name, Property::Type::Colour,
      [of](const Plan& plan, const Item& item) {
        const Rgb& rgb = of(const_cast<Plan&>(plan), item);
        return QVariant(QColor(rgb.r, rgb.g, rgb.b));
      },
      [of](Plan& plan, const Item& item, const QVariant& value) {
        const QColor chosen = value.value<QColor>();
        of(plan, item) = {static_cast<std::uint8_t>(chosen.red()),
                          static_cast<std::uint8_t>(chosen.green()),
                          static_cast<std::uint8_t>(chosen.blue())};
      });
}

}  // namespace eyebridge::gui
