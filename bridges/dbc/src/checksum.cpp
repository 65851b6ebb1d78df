#include "eyebridge/bridges/dbc/checksum.hpp"

namespace eyebridge::bridges::dbc {
namespace {

constexpr unsigned kPolynomial = 0x1D;

std::uint8_t crc_step(std::uint8_t crc, std::uint8_t byte) {
  unsigned bits = crc ^ byte;
  for (int i = 0; i < 8; ++i) bits = (bits & 0x80U) != 0 ? bits << 1 ^ kPolynomial : bits << 1;
  return static_cast<std::uint8_t>(bits);
}

std::uint8_t crc_over(std::uint8_t crc, std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) crc = crc_step(crc, byte);
  return crc;
}

}  // namespace

std::uint8_t xor_of(std::span<const std::uint8_t> bytes, std::uint8_t start) {
  unsigned sum = start;
  for (const std::uint8_t byte : bytes) sum ^= byte;
  return static_cast<std::uint8_t>(sum);
}

std::uint8_t sae_j1850(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint8_t>(crc_over(0xFF, bytes) ^ 0xFFU);
}

std::uint8_t autosar_profile1(std::uint16_t data_id, DataIdMode mode, std::uint8_t counter,
                              std::span<const std::uint8_t> bytes, std::size_t crc_at) {
  const auto low = static_cast<std::uint8_t>(data_id & 0xFFU);
  const auto high = static_cast<std::uint8_t>(data_id >> 8);
  std::uint8_t crc = 0;
  switch (mode) {
    case DataIdMode::Both:
      crc = crc_step(crc_step(0, low), high);
      break;
    case DataIdMode::Alternating:
      crc = crc_step(0, counter % 2 == 0 ? low : high);
      break;
    case DataIdMode::Low:
      crc = crc_step(0, low);
      break;
    case DataIdMode::Nibble:
      crc = crc_step(crc_step(0, low), 0);
      break;
  }
  return crc_over(crc_over(crc, bytes.first(crc_at)), bytes.subspan(crc_at + 1));
}

}  // namespace eyebridge::bridges::dbc
