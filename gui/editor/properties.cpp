#include "editor/properties.hpp"

#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "editor/edits.hpp"
#include "editor/property_rows.hpp"

namespace eyebridge::gui {
namespace {

/// What is moved by its place, typed: alone, without neighbours of other kinds.
void put(Plan& plan, const Item& item, Vec2 to) {
  if (const auto pose = pose_of(plan, item)) move_items(plan, {item}, to - pose->position());
}

}  // namespace

void Rows::add_pose(std::vector<Property>& rows, bool with_heading) {
  rows.push_back(number(
      tr("x"), "mm", -kFarthest_mm, kFarthest_mm, 1,
      [](const Plan& plan, const Item& item) {
        const auto pose = pose_of(plan, item);
        return pose ? QVariant(m_to_mm(pose->x)) : QVariant();
      },
      [](Plan& plan, const Item& item, const QVariant& value) {
        const auto pose = pose_of(plan, item);
        if (pose) put(plan, item, {mm_to_m(value.toDouble()), pose->y});
      }));
  rows.push_back(number(
      tr("y"), "mm", -kFarthest_mm, kFarthest_mm, 1,
      [](const Plan& plan, const Item& item) {
        const auto pose = pose_of(plan, item);
        return pose ? QVariant(m_to_mm(pose->y)) : QVariant();
      },
      [](Plan& plan, const Item& item, const QVariant& value) {
        const auto pose = pose_of(plan, item);
        if (pose) put(plan, item, {pose->x, mm_to_m(value.toDouble())});
      }));
  if (!with_heading) return;
  rows.push_back(number(
      tr("Heading"), "°", -360, 360, 1,
      [](const Plan& plan, const Item& item) {
        const auto pose = pose_of(plan, item);
        return pose ? QVariant(rad_to_deg(pose->theta)) : QVariant();
      },
      [](Plan& plan, const Item& item, const QVariant& value) {
        turn_item(plan, item, deg_to_rad(value.toDouble()));
      }));
}

std::vector<Property> Rows::floor() {
  const auto width = [](Plan& plan, const Item&) -> double& { return plan.width; };
  const auto height = [](Plan& plan, const Item&) -> double& { return plan.height; };
  std::vector<Property> rows;
  rows.push_back(length(tr("Width"), 1, kFarthest_mm, width));
  rows.push_back(length(tr("Height"), 1, kFarthest_mm, height));
  Property cell = number(
      tr("Maze cell"), "mm", 0, 100000, 1,
      [](const Plan& plan, const Item&) { return m_to_mm(plan.cell.value_or(0.0)); },
      [](Plan& plan, const Item&, const QVariant& value) {
        plan.cell.reset();
        if (value.toDouble() > 0) plan.cell = mm_to_m(value.toDouble());
      });
  cell.none = tr("by itself");
  rows.push_back(cell);
  rows.push_back(other(
      tr("Texture"), Property::Type::Text,
      [](const Plan& plan, const Item&) {
        return QString::fromStdString(plan.texture.value_or(""));
      },
      [](Plan& plan, const Item&, const QVariant& value) {
        plan.texture.reset();
        if (!value.toString().isEmpty()) plan.texture = value.toString().toStdString();
      }));
  return rows;
}

std::vector<Property> Rows::wall() {
  const auto end = [](Vec2 world::Wall::*which, double Vec2::*axis) {
    return std::pair<Get, Set>(
        [=](const Plan& plan, const Item& item) {
          return m_to_mm(plan.walls[item.index].*which.*axis);
        },
        [=](Plan& plan, const Item& item, const QVariant& value) {
          const Vec2 from = plan.walls[item.index].*which;
          Vec2 to = from;
          to.*axis = mm_to_m(value.toDouble());
          move_vertex(plan, from, to);
        });
  };
  std::vector<Property> rows;
  for (const auto& [name, which, axis] : {std::tuple(tr("x1"), &world::Wall::a, &Vec2::x),
                                          std::tuple(tr("y1"), &world::Wall::a, &Vec2::y),
                                          std::tuple(tr("x2"), &world::Wall::b, &Vec2::x),
                                          std::tuple(tr("y2"), &world::Wall::b, &Vec2::y)}) {
    auto [get, set] = end(which, axis);
    rows.push_back(number(name, "mm", -kFarthest_mm, kFarthest_mm, 1, get, set));
  }
  rows.push_back(length(tr("Thickness"), 0, 1e5, [](Plan& plan, const Item& item) -> double& {
    return plan.walls[item.index].thickness;
  }));
  rows.push_back(length(tr("Height"), 0.1, 1e5, [](Plan& plan, const Item& item) -> double& {
    return plan.walls[item.index].height;
  }));
  rows.push_back(colour(tr("Colour"), [](Plan& plan, const Item& item) -> Rgb& {
    return plan.walls[item.index].colour;
  }));
  return rows;
}

std::vector<Property> Rows::marker() {
  std::vector<Property> rows;
  add_pose(rows, false);
  rows.push_back(colour(tr("Colour"), [](Plan& plan, const Item& item) -> Rgb& {
    return plan.markers[item.index].colour;
  }));
  return rows;
}

std::vector<Property> Rows::start() {
  std::vector<Property> rows;
  add_pose(rows, true);
  Property letter = other(
      tr("Letter"), Property::Type::Choice,
      [](const Plan& plan, const Item& item) {
        const char c = plan.starts[item.index].letter;
        return c == 0 ? tr("none") : QString(QChar(c));
      },
      [](Plan& plan, const Item& item, const QVariant& value) {
        const QString text = value.toString();
        const bool is_letter = text.size() == 1;
        plan.starts[item.index].letter = is_letter ? text[0].toLatin1() : '\0';
      });
  letter.choices = {tr("none"), "S", "U", "D", "L", "R", "s", "u", "d", "l", "r"};
  rows.push_back(letter);
  return rows;
}

QString Rows::name(Kind kind) {
  switch (kind) {
    case Kind::Wall:
      return tr("Wall");
    case Kind::Marker:
      return tr("Marker");
    case Kind::Start:
      return tr("Start");
    case Kind::Thing:
      return tr("Object");
    case Kind::Robot:
      return tr("Robot");
  }
  return {};
}

std::vector<Property> floor_properties() { return Rows::floor(); }

std::vector<Property> properties_of(Kind kind, const Catalogue& catalogue) {
  switch (kind) {
    case Kind::Wall:
      return Rows::wall();
    case Kind::Marker:
      return Rows::marker();
    case Kind::Start:
      return Rows::start();
    case Kind::Thing:
      return Rows::thing();
    case Kind::Robot:
      return Rows::robot(catalogue);
  }
  return {};
}

QString name_of(Kind kind) { return Rows::name(kind); }

}  // namespace eyebridge::gui
