#include "eyebridge/hal/robot_server.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "eyebridge/camera/view.hpp"
#include "remote_robot/answer.hpp"
#include "remote_robot/message.hpp"
#include "remote_robot/message_stream.hpp"
#include "remote_robot/trace_messages.hpp"

namespace eyebridge::hal {
namespace {

constexpr std::array kKindsWithFacts = {"psd",     "proximity", "bumper", "motor",
                                        "encoder", "servo",     "robot"};

/// The program's computer has these.
bool is_of_host(const ListedDevice& device) {
  return device.kind == "serial" || device.kind == "sound";
}

/// Takes a trace in the thread that steps the world, gives it away in the server's.
class KeptTrace final : public TraceSink {
 public:
  void point(const TracePoint& point) noexcept override {
    const std::lock_guard lock(mutex_);
    messages_.point(point);
  }
  void contact(const TraceContact& contact) noexcept override {
    const std::lock_guard lock(mutex_);
    messages_.contact(contact);
  }
  std::vector<Message> take() {
    const std::lock_guard lock(mutex_);
    return messages_.take();
  }

 private:
  std::mutex mutex_;
  TraceMessages messages_;
};

}  // namespace

struct RobotServer::Impl {
  Impl(Backend& given, const Time* limit, int socket, std::function<void()> to_arrive)
      : robot(given),
        limit_of_clock(limit),
        arrive(std::move(to_arrive)),
        stream(socket, LineMemory::offer(socket), MessageStream::End::World) {}

  [[nodiscard]] Time limit() const { return limit_of_clock != nullptr ? *limit_of_clock : now(); }
  [[nodiscard]] Time now() const { return robot.clock().now(); }
  [[nodiscard]] Message welcome() const;
  Result<Values> carry_out();

  Backend& robot;
  const Time* const limit_of_clock;
  const std::function<void()> arrive;
  KeptTrace trace;
  MessageStream stream;
  RobotRequest request;
};

Message RobotServer::Impl::welcome() const {
  RobotWelcome welcome;
  welcome.now = now();
  welcome.limit = limit();
  welcome.is_virtual = robot.clock().is_virtual();
  welcome.robot_id = robot.robot_id();
  welcome.radio = robot.radio_conditions();
  welcome.has_world = robot.world() != nullptr;
  if (const camera::View* const view = robot.camera_view()) {
    welcome.has_view = true;
    welcome.carrier = view->carrier();
    welcome.texture_directory = view->texture_directory();
  }
  welcome.devices = devices_of(robot);
  std::erase_if(welcome.devices, is_of_host);
  for (const char* kind : kKindsWithFacts) welcome.facts.emplace_back(kind, robot.facts_of(kind));
  return encode(welcome);
}

Result<Values> RobotServer::Impl::carry_out() {
  if (request.device != "robot") {
    return hal::answer(
        robot, {request.device, request.id, request.name, request.is_command, request.request});
  }
  if (request.name == "trace") {
    robot.trace_to(request.request == Values{1.0} ? &trace : nullptr);
  } else if (request.name == "stop") {
    if (auto stopped = robot.stop(); !stopped) return tl::unexpected(std::move(stopped.error()));
  } else if (request.name == "arrive") {
    if (arrive) arrive();
  } else if (request.name != "now") {
    return fail(Errc::Unsupported, fmt::format("a robot has no {}", request.name));
  }
  return Values{};
}

RobotServer::RobotServer(Backend& robot, const Time* limit, int socket,
                         std::function<void()> arrive)
    : impl_(std::make_unique<Impl>(robot, limit, socket, std::move(arrive))) {}

RobotServer::~RobotServer() { impl_->robot.trace_to(nullptr); }

Result<void> RobotServer::receive() {
  const Result<Message> message = impl_->stream.receive(MessageStream::Wait::Awake);
  if (!message) return tl::unexpected(message.error());
  std::optional<RobotRequest> request = decode_request(*message);
  if (!request) {
    return fail(Errc::Corrupt, fmt::format("found {} bytes that are no question of a robot's "
                                           "program; expected one of the same version",
                                           message->size()));
  }
  impl_->request = std::move(*request);
  return {};
}

Result<void> RobotServer::answer() {
  Impl& me = *impl_;
  const RobotRequest& request = me.request;
  if (me.robot.clock().is_virtual()) me.robot.clock().wait_until(request.time);
  Result<Values> values = Values{};
  if (request.device == "robot" && request.name == "hello") {
    if (me.arrive && !me.robot.clock().is_virtual()) me.arrive();
    if (request.request == Values{kRobotLineVersion}) return me.stream.send(me.welcome());
    values = fail(Errc::Unsupported,
                  "the program has libeyebridge of another version than the robots' world");
  } else {
    values = me.carry_out();
  }
  for (const Message& part : me.trace.take()) {
    if (Result<void> sent = me.stream.send(part); !sent) return sent;
  }
  return me.stream.send(encode(RobotReply{me.now(), me.limit(), std::move(values)}));
}

}  // namespace eyebridge::hal
