// What can be said of things and robots.
#include <QProcess>
#include <QRegularExpression>
#include <optional>
#include <string>

#include "editor/edits.hpp"
#include "editor/property_rows.hpp"

namespace eyebridge::gui {
namespace {

/// A thing's matter and way, as its own words or as lines after a described object say them.
struct Behaviour {
  std::optional<double> mass, friction, restitution;
  bool fixed = false;
};
Behaviour behaviour_of(const Plan& plan, const Item& item) {
  if (item.kind == Kind::Thing) {
    const world::Matter& matter = plan.things[item.index].spec.matter;
    return {matter.mass, matter.friction, matter.restitution, matter.fixed};
  }
  const files::ObjectTraits& traits = plan.robots[item.index].traits;
  return {traits.mass, traits.friction, traits.restitution, traits.fixed};
}
void behave(Plan& plan, const Item& item, const Behaviour& behaviour) {
  if (item.kind == Kind::Thing) {
    Thing& thing = plan.things[item.index];
    thing.is_drawn = false;
    thing.spec.matter = {behaviour.mass.value_or(thing.spec.matter.mass), behaviour.friction,
                         behaviour.restitution, behaviour.fixed};
    return;
  }
  files::ObjectTraits& traits = plan.robots[item.index].traits;
  traits.any = true;
  traits.mass = behaviour.mass;
  traits.friction = behaviour.friction;
  traits.restitution = behaviour.restitution;
  traits.fixed = behaviour.fixed;
  traits.loose = traits.loose && !behaviour.fixed;
}

Property open_number(const QString& name, const QString& none, double high,
                     std::optional<double> Behaviour::*member) {
  Property row = number(
      name, {}, kOpen, high, 3,
      [member](const Plan& plan, const Item& item) {
        return (behaviour_of(plan, item).*member).value_or(kOpen);
      },
      [member](Plan& plan, const Item& item, const QVariant& value) {
        Behaviour behaviour = behaviour_of(plan, item);
        behaviour.*member =
            value.toDouble() < 0 ? std::nullopt : std::optional<double>(value.toDouble());
        behave(plan, item, behaviour);
      });
  row.none = none;
  return row;
}

}  // namespace

void Rows::add_matter(std::vector<Property>& rows) {
  rows.push_back(open_number(tr("Mass (kg)"), tr("as described"), 10000, &Behaviour::mass));
  rows.push_back(open_number(tr("Friction"), tr("as usual"), 100, &Behaviour::friction));
  rows.push_back(open_number(tr("Restitution"), tr("as usual"), 1, &Behaviour::restitution));
  rows.push_back(other(
      tr("Fixed"), Property::Type::Flag,
      [](const Plan& plan, const Item& item) { return behaviour_of(plan, item).fixed; },
      [](Plan& plan, const Item& item, const QVariant& value) {
        Behaviour behaviour = behaviour_of(plan, item);
        behaviour.fixed = value.toBool();
        behave(plan, item, behaviour);
        // Its file may say that it is fixed.
        if (item.kind == Kind::Robot) plan.robots[item.index].traits.loose = !behaviour.fixed;
      }));
}

void Rows::add_way(std::vector<Property>& rows) {
  rows.push_back(number(
      tr("Way: speed"), "mm/s", 0.1, 100000, 1,
      [](const Plan& plan, const Item& item) {
        const world::Path* const way = way_of(plan, item);
        return way == nullptr ? QVariant() : QVariant(m_to_mm(way->speed));
      },
      [](Plan& plan, const Item& item, const QVariant& value) {
        if (way_of(plan, item) != nullptr) make_way(plan, item)->speed = mm_to_m(value.toDouble());
      }));
  rows.push_back(other(
      tr("Way: round and round"), Property::Type::Flag,
      [](const Plan& plan, const Item& item) {
        const world::Path* const way = way_of(plan, item);
        return way == nullptr ? QVariant() : QVariant(way->loop);
      },
      [](Plan& plan, const Item& item, const QVariant& value) {
        if (way_of(plan, item) == nullptr) return;
        world::Path& way = *make_way(plan, item);
        way.loop = value.toBool();
        fit_profile(way);
      }));
}

Property Rows::corners() {
  return other(
      tr("Corners (mm)"), Property::Type::Text,
      [](const Plan& plan, const Item& item) {
        const world::ObjectSpec& spec = plan.things[item.index].spec;
        if (spec.kind != world::ObjectKind::Polygon) return QVariant();
        QStringList places;
        for (const Vec2 corner : spec.corners) {
          places << QString("%1, %2")
                        .arg(m_to_mm(corner.x), 0, 'g', 10)
                        .arg(m_to_mm(corner.y), 0, 'g', 10);
        }
        return QVariant(places.join("; "));
      },
      [](Plan& plan, const Item& item, const QVariant& value) {
        world::ObjectSpec& spec = plan.things[item.index].spec;
        if (spec.kind != world::ObjectKind::Polygon) return;
        QString places = value.toString();
        places.replace(QRegularExpression("[,;]"), " ");
        try {  // as a file says it, and what no file can say changes nothing
          spec.corners =
              files::read_object_text("polygon 0 0 0 " + places.toStdString(), "corners").corners;
          spec.radius = spec.outer_radius();
        } catch (const ConfigError&) {
        }
      });
}

std::vector<Property> Rows::thing() {
  std::vector<Property> rows;
  add_pose(rows, true);
  // Only boxes and polygons have sizes of their own: files cannot say others.
  const auto of_block = [](const QString& name, world::ObjectKind only, auto member) {
    const auto fits = [only](const world::ObjectSpec& spec) {
      return spec.kind == world::ObjectKind::Box || spec.kind == only;
    };
    return number(
        name, "mm", 1, 10000, 1,
        [=](const Plan& plan, const Item& item) {
          const world::ObjectSpec& spec = plan.things[item.index].spec;
          return fits(spec) ? QVariant(m_to_mm(member(const_cast<world::ObjectSpec&>(spec))))
                            : QVariant();
        },
        [=](Plan& plan, const Item& item, const QVariant& value) {
          world::ObjectSpec& spec = plan.things[item.index].spec;
          if (!fits(spec)) return;
          member(spec) = mm_to_m(value.toDouble());
          spec.radius = spec.outer_radius();
        });
  };
  const auto box = world::ObjectKind::Box;
  const auto polygon = world::ObjectKind::Polygon;
  using Spec = world::ObjectSpec;
  rows.push_back(of_block(tr("Length"), box, [](Spec& o) -> double& { return o.size.x; }));
  rows.push_back(of_block(tr("Width"), box, [](Spec& o) -> double& { return o.size.y; }));
  rows.push_back(of_block(tr("Height"), polygon, [](Spec& o) -> double& { return o.height; }));
  rows.push_back(corners());
  Property paint = colour(tr("Colour"), [](Plan& plan, const Item& item) -> Rgb& {
    return plan.things[item.index].spec.colour;
  });
  const Get any_colour = paint.get;
  paint.get = [any_colour](const Plan& plan, const Item& item) {
    const world::ObjectKind kind = plan.things[item.index].spec.kind;
    return kind == box || kind == polygon ? any_colour(plan, item) : QVariant();
  };
  rows.push_back(paint);
  add_matter(rows);
  // A thing that needs no description always has a mass.
  for (Property& row : rows) {
    if (row.name != tr("Mass (kg)")) continue;
    row.low = 0.001;
    row.none.clear();
  }
  add_way(rows);
  return rows;
}

std::vector<Property> Rows::robot(const Catalogue& catalogue) {
  std::vector<Property> rows;
  Property model = other(
      tr("Model"), Property::Type::Choice,
      [](const Plan& plan, const Item& item) {
        return QString::fromStdString(plan.robots[item.index].model);
      },
      [](Plan& plan, const Item& item, const QVariant& value) {
        if (!value.toString().isEmpty())
          plan.robots[item.index].model = value.toString().toStdString();
      });
  for (const std::string& name : catalogue.names()) model.choices << QString::fromStdString(name);
  rows.push_back(model);
  add_pose(rows, true);
  const auto is_object = [catalogue](const Plan& plan, const Item& item) {
    return catalogue.find(plan.robots[item.index].model).is_object;
  };
  const auto only = [&](bool for_objects, std::size_t from) {
    for (std::size_t i = from; i < rows.size(); ++i) {
      rows[i].get = [=, get = rows[i].get](const Plan& plan, const Item& item) {
        return is_object(plan, item) == for_objects ? get(plan, item) : QVariant();
      };
    }
  };
  const std::size_t first = rows.size();
  rows.push_back(other(
      tr("Program"), Property::Type::Text,
      [](const Plan& plan, const Item& item) {
        return QString::fromStdString(plan.robots[item.index].program);
      },
      [](Plan& plan, const Item& item, const QVariant& value) {
        plan.robots[item.index].program = value.toString().toStdString();
      }));
  rows.push_back(other(
      tr("Arguments"), Property::Type::Text,
      [](const Plan& plan, const Item& item) {
        QStringList words;
        for (const std::string& argument : plan.robots[item.index].arguments) {
          const QString word = QString::fromStdString(argument);
          words << (word.isEmpty() || word.contains(' ') ? '"' + word + '"' : word);
        }
        return words.join(' ');
      },
      [](Plan& plan, const Item& item, const QVariant& value) {
        std::vector<std::string>& words = plan.robots[item.index].arguments;
        words.clear();
        for (const QString& word : QProcess::splitCommand(value.toString())) {
          words.push_back(word.toStdString());
        }
      }));
  Property enters = number(
      tr("Enters after"), "s", 0, 1e6, 3,
      [](const Plan& plan, const Item& item) {
        return plan.robots[item.index].enters.value_or(0.0);
      },
      [catalogue](Plan& plan, const Item& item, const QVariant& value) {
        const auto is_described = [&](const std::string& name) {
          return catalogue.find(name).is_object;
        };
        keep_numbers(plan, is_described, [&] {
          plan.robots[item.index].enters.reset();
          if (value.toDouble() > 0) plan.robots[item.index].enters = value.toDouble();
        });
      });
  enters.none = tr("from the start");
  rows.push_back(enters);
  only(false, first);
  const std::size_t second = rows.size();
  add_matter(rows);
  add_way(rows);
  only(true, second);
  return rows;
}

}  // namespace eyebridge::gui
