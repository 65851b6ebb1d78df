#include "remote_robot/message.hpp"

#include <utility>

namespace eyebridge::hal {
namespace {

void write(ByteWriter& writer, Time time) { writer.number<std::int64_t>(time.count()); }
Time read_time(ByteReader& reader) { return Time(reader.number<std::int64_t>()); }

void write(ByteWriter& writer, const DeviceFacts& facts) {
  writer.number<std::int32_t>(facts.id);
  writer.text(facts.name);
  writer.number<std::int32_t>(facts.semantics);
  writer.number(facts.ticks_per_metre);
}
DeviceFacts read_facts(ByteReader& reader) {
  DeviceFacts facts;
  facts.id = reader.number<std::int32_t>();
  facts.name = reader.text();
  facts.semantics = reader.number<std::int32_t>();
  facts.ticks_per_metre = reader.number<double>();
  return facts;
}
constexpr std::size_t kLeastFacts = 4 + 4 + 4 + 8;  // bytes
constexpr std::size_t kLeastDevice = 4 + 4 + 4;     // likewise
constexpr std::size_t kLeastFactsOfKind = 4 + 4;    // likewise

void write(ByteWriter& writer, const RadioConditions& radio) {
  writer.number(radio.loss);
  write(writer, radio.delay);
  write(writer, radio.jitter);
  writer.number(radio.corrupt);
  writer.number(radio.range);
}
RadioConditions read_radio(ByteReader& reader) {
  RadioConditions radio;
  radio.loss = reader.number<double>();
  radio.delay = read_time(reader);
  radio.jitter = read_time(reader);
  radio.corrupt = reader.number<double>();
  radio.range = reader.number<double>();
  return radio;
}

template <class Struct>
std::optional<Struct> whole_only(const ByteReader& reader, Struct&& value) {
  if (!reader.complete()) return std::nullopt;
  return std::forward<Struct>(value);
}

}  // namespace

void begin(ByteWriter& writer, MessageKind kind) { writer.number(static_cast<std::uint8_t>(kind)); }

ByteReader opened(std::span<const std::uint8_t> message, MessageKind kind) {
  ByteReader reader(message);
  if (reader.number<std::uint8_t>() != static_cast<std::uint8_t>(kind)) reader.refuse();
  return reader;
}

std::optional<MessageKind> kind_of(std::span<const std::uint8_t> message) {
  if (message.empty()) return std::nullopt;
  const auto kind = static_cast<MessageKind>(message.front());
  for (const MessageKind known :
       {MessageKind::Request, MessageKind::Reply, MessageKind::Welcome, MessageKind::Trace}) {
    if (kind == known) return kind;
  }
  return std::nullopt;
}

Message encode(const RobotRequest& request) {
  ByteWriter writer;
  begin(writer, MessageKind::Request);
  write(writer, request.time);
  writer.text(request.device);
  writer.number<std::int32_t>(request.id);
  writer.text(request.name);
  writer.flag(request.is_command);
  writer.values(request.request);
  return writer.take();
}

std::optional<RobotRequest> decode_request(std::span<const std::uint8_t> message) {
  ByteReader reader = opened(message, MessageKind::Request);
  RobotRequest request;
  request.time = read_time(reader);
  request.device = reader.text();
  request.id = reader.number<std::int32_t>();
  request.name = reader.text();
  request.is_command = reader.flag();
  request.request = reader.values();
  return whole_only(reader, std::move(request));
}

Message encode(const RobotReply& reply) {
  ByteWriter writer;
  begin(writer, MessageKind::Reply);
  write(writer, reply.now);
  write(writer, reply.limit);
  writer.flag(reply.values.has_value());
  if (reply.values) {
    writer.values(*reply.values);
  } else {
    writer.number(static_cast<std::uint8_t>(reply.values.error().code));
    writer.text(reply.values.error().what);
  }
  return writer.take();
}

std::optional<RobotReply> decode_reply(std::span<const std::uint8_t> message) {
  ByteReader reader = opened(message, MessageKind::Reply);
  RobotReply reply;
  reply.now = read_time(reader);
  reply.limit = read_time(reader);
  if (reader.flag()) {
    reply.values = reader.values();
  } else {
    const auto code = reader.number<std::uint8_t>();
    if (code > static_cast<std::uint8_t>(Errc::NoDevice)) reader.refuse();
    reply.values = fail(static_cast<Errc>(code), reader.text());
  }
  return whole_only(reader, std::move(reply));
}

Message encode(const RobotWelcome& welcome) {
  ByteWriter writer;
  begin(writer, MessageKind::Welcome);
  write(writer, welcome.now);
  write(writer, welcome.limit);
  writer.flag(welcome.is_virtual);
  writer.number<std::int32_t>(welcome.robot_id);
  write(writer, welcome.radio);
  writer.flag(welcome.has_world);
  writer.flag(welcome.has_view);
  writer.number(welcome.carrier);
  writer.text(welcome.texture_directory);
  writer.size(welcome.devices.size());
  for (const ListedDevice& device : welcome.devices) {
    writer.text(device.kind);
    writer.number<std::int32_t>(device.id);
    writer.values(device.facts);
  }
  writer.size(welcome.facts.size());
  for (const auto& [kind, list] : welcome.facts) {
    writer.text(kind);
    writer.size(list.size());
    for (const DeviceFacts& facts : list) write(writer, facts);
  }
  return writer.take();
}

std::optional<RobotWelcome> decode_welcome(std::span<const std::uint8_t> message) {
  ByteReader reader = opened(message, MessageKind::Welcome);
  RobotWelcome welcome;
  welcome.now = read_time(reader);
  welcome.limit = read_time(reader);
  welcome.is_virtual = reader.flag();
  welcome.robot_id = reader.number<std::int32_t>();
  welcome.radio = read_radio(reader);
  welcome.has_world = reader.flag();
  welcome.has_view = reader.flag();
  welcome.carrier = reader.number<std::uint32_t>();
  welcome.texture_directory = reader.text();
  for (std::size_t left = reader.size(kLeastDevice); left > 0 && reader.good(); --left) {
    ListedDevice& device = welcome.devices.emplace_back();
    device.kind = reader.text();
    device.id = reader.number<std::int32_t>();
    device.facts = reader.values();
  }
  for (std::size_t left = reader.size(kLeastFactsOfKind); left > 0 && reader.good(); --left) {
    auto& [kind, list] = welcome.facts.emplace_back();
    kind = reader.text();
    for (std::size_t more = reader.size(kLeastFacts); more > 0 && reader.good(); --more) {
      list.push_back(read_facts(reader));
    }
  }
  return whole_only(reader, std::move(welcome));
}

}  // namespace eyebridge::hal
