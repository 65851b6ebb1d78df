#include "environment/readings.hpp"

#include <QHeaderView>

#include "eyebridge/base/units.hpp"

namespace eyebridge::gui {
namespace {

QString pose_text(const Pose& pose) {
  return QString("%1  %2 mm  %3°")
      .arg(m_to_mm(pose.x), 0, 'f', 0)
      .arg(m_to_mm(pose.y), 0, 'f', 0)
      .arg(rad_to_deg(pose.theta), 0, 'f', 1);
}

QString name_of(const std::string& name, const char* kind, int id) {
  return name.empty() ? QString("%1 %2").arg(kind).arg(id) : QString::fromStdString(name);
}

}  // namespace

Readings::Readings(QWidget* parent) : QTableWidget(0, 2, parent) {
  setHorizontalHeaderLabels({tr("What"), tr("Value")});
  horizontalHeader()->setStretchLastSection(true);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionMode(QAbstractItemView::NoSelection);
  setFocusPolicy(Qt::NoFocus);
}

void Readings::put(const QString& name, const QString& value) {
  if (next_ == rowCount()) {
    insertRow(next_);
    setItem(next_, 0, new QTableWidgetItem);
    setItem(next_, 1, new QTableWidgetItem);
  }
  // Text that is set anew is painted anew.
  if (item(next_, 0)->text() != name) item(next_, 0)->setText(name);
  if (item(next_, 1)->text() != value) item(next_, 1)->setText(value);
  ++next_;
}

void Readings::show_robot(const hal::WorldLook& look, Mirror& mirror,
                          std::optional<std::size_t> robot) {
  next_ = 0;
  if (robot && *robot < look.robots.size()) {
    const hal::RobotLook& seen = look.robots[*robot];
    put(tr("robot"),
        QString("%1 (%2)").arg(*robot + 1).arg(QString::fromStdString(seen.model->name)));
    put(tr("pose"), pose_text(seen.pose));
    if (seen.depth) put(tr("depth"), QString("%1 mm").arg(m_to_mm(*seen.depth), 0, 'f', 0));
    put(tr("odometry"), pose_text(seen.odometry));
    put(tr("speed"), QString("%1 mm/s  %2°/s")
                         .arg(m_to_mm(seen.twist.linear), 0, 'f', 0)
                         .arg(rad_to_deg(seen.twist.angular), 0, 'f', 0));
    if (seen.stalled != robot::kStallNone) put(tr("wheels"), tr("stalled"));
    put_sensors(seen, mirror, *robot);
  }
  setRowCount(next_);
}

void Readings::put_sensors(const hal::RobotLook& robot, Mirror& mirror, std::size_t index) {
  const auto& sensors = robot.model->range_sensors;
  const std::vector<SensorRay> rays = mirror.distance_rays(index);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    put(name_of(sensors[i].name, "PSD", sensors[i].id),
        QString("%1 mm").arg(m_to_mm(rays[i].range), 0, 'f', 0));
  }
  const auto& switches = robot.model->proximity_sensors;
  const std::vector<SensorRay> near = mirror.proximity_rays(index);
  for (std::size_t i = 0; i < near.size(); ++i) {
    put(name_of(switches[i].name, "IR", switches[i].id),
        near[i].range < switches[i].threshold ? tr("near") : tr("free"));
  }
  const std::vector<bool> touched = mirror.bumpers(index);
  for (std::size_t i = 0; i < touched.size(); ++i) {
    put(name_of(robot.model->bumpers[i].name, "bumper", robot.model->bumpers[i].id),
        touched[i] ? tr("touched") : tr("free"));
  }
}

}  // namespace eyebridge::gui
