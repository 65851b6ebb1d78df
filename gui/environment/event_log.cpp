#include "environment/event_log.hpp"

#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {
namespace {

/// By the numbers that programs use.
QString name_of(std::optional<robot::RobotIndex> robot, std::optional<std::size_t> object) {
  if (robot) return EventLog::tr("robot %1").arg(*robot + 1);
  return object ? EventLog::tr("object %1").arg(*object + 1) : EventLog::tr("a wall");
}

}  // namespace

EventLog::EventLog(QWidget* parent) : QListWidget(parent) {
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setUniformItemSizes(true);
}

void EventLog::add(const hal::WorldLook& look) {
  for (const robot::CollisionEvent& event : look.collisions) {
    if (!event.robot && !event.with_robot) continue;  // things among themselves
    add(tr("%1 s: %2 hit %3 at %4, %5 mm")
            .arg(event.time, 0, 'f', 2)
            .arg(name_of(event.robot, event.object), name_of(event.with_robot, event.with_object))
            .arg(m_to_mm(event.place.x), 0, 'f', 0)
            .arg(m_to_mm(event.place.y), 0, 'f', 0));
  }
}

void EventLog::add(const QString& text) {
  addItem(text);
  while (count() > kLongest) delete takeItem(0);
  scrollToBottom();
}

}  // namespace eyebridge::gui
