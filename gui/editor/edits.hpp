#pragma once

#include <functional>
#include <string>
#include <vector>

#include "editor/plan.hpp"

namespace eyebridge::gui {

// What a person does to a plan, one function each: no history, no screen.

/// Moves what is selected. The ends of walls take along every wall that shares them; of several
/// things, their ways go with them, of one alone its way stays. A robot at a start letter leaves
/// it.
void move_items(Plan& plan, const Selection& items, Vec2 by);
/// Moves all ends of walls at `from`.
void move_vertex(Plan& plan, Vec2 from, Vec2 to);
/// Gives a robot, start or thing this heading, radians; others have none.
void turn_item(Plan& plan, const Item& item, double theta);
/// Two walls instead of one, that meet at the point of it nearest to `at`; false when that is an
/// end.
bool split_wall(Plan& plan, std::size_t wall, Vec2 at);
/// The walls without length that are left when ends meet.
void drop_points(Plan& plan);
/// Whether a model, by the name that a line gives, is that of an object.
using IsObject = std::function<bool(const std::string& model)>;
/// The number that a run gives each robot, 0 for objects: those that enter come last, by time.
std::vector<int> run_numbers(const std::vector<files::SimRobot>& robots, const IsObject& is_object);
/// Does `change`, which adds robots behind those there are or changes some where they are: errors
/// of a robot then follow its number.
void keep_numbers(Plan& plan, const IsObject& is_object, const std::function<void()>& change);
/// Removes what is selected. Errors of a robot go with it, those of others follow their numbers.
void remove_items(Plan& plan, const Selection& items, const IsObject& is_object);

/// What is selected as a plan of its own, to be pasted.
Plan copy_of(const Plan& plan, const Selection& items);
/// Adds all of `clip`, moved; what has been added.
Selection paste(Plan& plan, const Plan& clip, Vec2 by);

Item add_wall(Plan& plan, Vec2 a, Vec2 b, const world::Wall& like);
/// A built-in thing, by its name.
Item add_thing(Plan& plan, const std::string& name, Vec2 at);
Item add_marker(Plan& plan, Vec2 at);
Item add_robot(Plan& plan, const std::string& model, Vec2 at);
Item add_start(Plan& plan, Vec2 at);
/// A point of the way of `item`, before the one at `before`; a way begins with its first one.
/// False where the point before or after is the same one, or nothing can move.
bool add_way_point(Plan& plan, const Item& item, std::size_t before, Vec2 at);
/// With its last point a thing's way goes.
void remove_way_point(Plan& plan, const Item& item, std::size_t point);
void move_way_point(Plan& plan, const Item& item, std::size_t point, Vec2 to);

}  // namespace eyebridge::gui
