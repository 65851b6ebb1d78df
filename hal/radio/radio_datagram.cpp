#include "radio/radio_datagram.hpp"

#include <algorithm>
#include <array>

#include "eyebridge/hal/radio.hpp"

namespace eyebridge::hal {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic = {'E', 'B', 'R', '1'};
constexpr std::size_t kRunAt = 8;
constexpr std::size_t kRunBytes = 8;
constexpr std::size_t kTextAt = kRunAt + kRunBytes;

}  // namespace

std::vector<std::uint8_t> encode(const RadioDatagram& datagram) {
  std::vector<std::uint8_t> bytes(kMagic.begin(), kMagic.end());
  bytes.push_back(static_cast<std::uint8_t>(datagram.kind));
  bytes.push_back(datagram.sender);
  bytes.push_back(datagram.receiver);
  bytes.push_back(0);
  for (std::size_t i = kRunBytes; i-- > 0;) {
    bytes.push_back(static_cast<std::uint8_t>(datagram.run >> (8 * i) & 0xFFU));
  }
  bytes.insert(bytes.end(), datagram.text.begin(), datagram.text.end());
  return bytes;
}

std::optional<RadioDatagram> decode_radio(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kTextAt || bytes.size() > kTextAt + Radio::kLongestText ||
      !std::equal(kMagic.begin(), kMagic.end(), bytes.begin())) {
    return std::nullopt;
  }
  RadioDatagram datagram;
  if (bytes[4] < static_cast<std::uint8_t>(RadioDatagram::Kind::Message) ||
      bytes[4] > static_cast<std::uint8_t>(RadioDatagram::Kind::Bye)) {
    return std::nullopt;
  }
  datagram.kind = static_cast<RadioDatagram::Kind>(bytes[4]);
  datagram.sender = bytes[5];
  datagram.receiver = bytes[6];
  if (datagram.sender == 0 || bytes[7] != 0) return std::nullopt;
  for (const std::uint8_t byte : bytes.subspan(kRunAt, kRunBytes)) {
    datagram.run = datagram.run << 8U | byte;
  }
  if (datagram.kind != RadioDatagram::Kind::Message && bytes.size() > kTextAt) return std::nullopt;
  datagram.text.assign(bytes.begin() + kTextAt, bytes.end());
  return datagram;
}

}  // namespace eyebridge::hal
