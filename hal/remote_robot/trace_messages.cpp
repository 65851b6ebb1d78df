#include "remote_robot/trace_messages.hpp"

#include <string>
#include <utility>

namespace eyebridge::hal {
namespace {

constexpr std::size_t kFullTrace = 1U << 20U;  // bytes
constexpr char kPoint = 'p';
constexpr char kContact = 'c';

void write(ByteWriter& writer, const Pose& pose) {
  for (const double value : {pose.x, pose.y, pose.theta}) writer.number(value);
}
Pose read_pose(ByteReader& reader) {
  Pose pose;
  for (double* value : {&pose.x, &pose.y, &pose.theta}) *value = reader.number<double>();
  return pose;
}

}  // namespace

void TraceMessages::begin(char what) {
  if (writer_.written() >= kFullTrace) full_.push_back(writer_.take());
  if (writer_.written() == 0) hal::begin(writer_, MessageKind::Trace);
  writer_.number(what);
}

void TraceMessages::point(const TracePoint& point) noexcept {
  begin(kPoint);
  writer_.number<std::int64_t>(point.time.count());
  write(writer_, point.pose);
  writer_.number(point.twist.linear);
  writer_.number(point.twist.angular);
  write(writer_, point.odometry);
  writer_.values(point.ranges);
}

void TraceMessages::contact(const TraceContact& contact) noexcept {
  begin(kContact);
  writer_.number<std::int64_t>(contact.time.count());
  writer_.text(contact.robot);
  writer_.text(contact.with);
  writer_.number(contact.place.x);
  writer_.number(contact.place.y);
}

std::vector<Message> TraceMessages::take() {
  if (writer_.written() > 0) full_.push_back(writer_.take());
  return std::exchange(full_, {});
}

bool tell_trace(std::span<const std::uint8_t> message, TraceSink& sink) {
  ByteReader reader = opened(message, MessageKind::Trace);
  while (reader.good() && !reader.at_end()) {
    const char what = reader.number<char>();
    const Time time = Time(reader.number<std::int64_t>());
    if (what == kPoint) {
      TracePoint point;
      point.time = time;
      point.pose = read_pose(reader);
      point.twist.linear = reader.number<double>();
      point.twist.angular = reader.number<double>();
      point.odometry = read_pose(reader);
      const Values ranges = reader.values();
      point.ranges = ranges;
      if (reader.good()) sink.point(point);
    } else if (what == kContact) {
      const std::string robot = reader.text();
      const std::string with = reader.text();
      const double x = reader.number<double>();
      const double y = reader.number<double>();
      if (reader.good()) sink.contact({time, robot, with, {x, y}});
    } else {
      reader.refuse();
    }
  }
  return reader.good();
}

}  // namespace eyebridge::hal
