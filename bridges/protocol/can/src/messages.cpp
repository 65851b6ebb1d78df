#include "eyebridge/bridges/can/messages.hpp"

#include <string>
#include <utility>

namespace eyebridge::bridges::can {
namespace {

template <class Message>
Result<AnyMessage> decode_as(const CanFrame& frame) {
  auto message = decode<Message>(frame);
  if (!message) return tl::unexpected(std::move(message.error()));
  return AnyMessage(*message);
}

using Decoder = Result<AnyMessage> (*)(const CanFrame&);

template <class... Messages>
Decoder find_decoder(std::variant<Messages...>*, int function, bool fd) {
  Decoder found = nullptr;
  ((Messages::kFunction == function&& Messages::kFd == fd ? found = decode_as<Messages> : found),
   ...);
  return found;
}

}  // namespace

Result<Received> decode_any(const CanFrame& frame) {
  const Decoder decoder =
      is_protocol_format(frame)
          ? find_decoder(static_cast<AnyMessage*>(nullptr), function_of(frame.id), frame.fd)
          : nullptr;
  if (decoder == nullptr) {
    return fail(Errc::Unsupported,
                "CAN frame with identifier " + std::to_string(frame.id) + " is none of ours");
  }
  auto message = decoder(frame);
  if (!message) return tl::unexpected(std::move(message.error()));
  return Received{node_of(frame.id), *message};
}

Result<CanFrame> encode_any(const Received& received) {
  return std::visit([&](const auto& message) { return encode(received.node, message); },
                    received.message);
}

}  // namespace eyebridge::bridges::can
