#include "eyebridge/bridges/dbc/checksum.hpp"

#include <string_view>
#include <vector>

#include <gmock/gmock.h>

namespace eyebridge::bridges::dbc {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(Checksum, XorCombinesAllBytes) {
  EXPECT_EQ(xor_of(Bytes{}), 0);
  EXPECT_EQ(xor_of(Bytes{0x12, 0x34, 0x56}), 0x12 ^ 0x34 ^ 0x56);
  EXPECT_EQ(xor_of(Bytes{0xFF}, 0x0F), 0xF0);
}

// The check value of the catalogue of CRCs, and the examples of AUTOSAR's specification of its CRC
// routines (SWS_CRCLibrary, 8-bit SAE J1850).
TEST(Checksum, SaeJ1850GivesThePublishedValues) {
  const std::string_view check = "123456789";
  EXPECT_EQ(sae_j1850(Bytes(check.begin(), check.end())), 0x4B);
  EXPECT_EQ(sae_j1850(Bytes{0x00, 0x00, 0x00, 0x00}), 0x59);
  EXPECT_EQ(sae_j1850(Bytes{0xF2, 0x01, 0x83}), 0x37);
  EXPECT_EQ(sae_j1850(Bytes{0x0F, 0xAA, 0x00, 0x55}), 0x79);
  EXPECT_EQ(sae_j1850(Bytes{0x00, 0xFF, 0x55, 0x11}), 0xB8);
  EXPECT_EQ(sae_j1850(Bytes{0x33, 0x22, 0x55, 0xAA, 0xBB, 0xCC, 0xDD, 0xEE, 0xFF}), 0xCB);
  EXPECT_EQ(sae_j1850(Bytes{0x92, 0x6B, 0x55}), 0x8C);
  EXPECT_EQ(sae_j1850(Bytes{0xFF, 0xFF, 0xFF, 0xFF}), 0x74);
}

// AUTOSAR PRS_E2EProtocol 6.3.5: data identifier 0x123, eight bytes of 0, CRC in byte 0, counter
// in the low nibble of byte 1; two frames after one another.
TEST(Checksum, AutosarProfile1GivesThePublishedValues) {
  const Bytes first(8);
  Bytes second(8);
  second[1] = 1;
  const auto crcs = [&](DataIdMode mode) {
    return std::pair<int, int>{autosar_profile1(0x123, mode, 0, first, 0),
                               autosar_profile1(0x123, mode, 1, second, 0)};
  };
  EXPECT_EQ(crcs(DataIdMode::Both), (std::pair{0xCC, 0x91}));
  EXPECT_EQ(crcs(DataIdMode::Alternating), (std::pair{0xCE, 0x02}));
  EXPECT_EQ(crcs(DataIdMode::Low), (std::pair{0xCE, 0x93}));
  Bytes nibble = first;
  nibble[1] = 0x10;
  EXPECT_EQ(autosar_profile1(0x123, DataIdMode::Nibble, 0, nibble, 0), 0x2A);
  nibble[1] = 0x11;
  EXPECT_EQ(autosar_profile1(0x123, DataIdMode::Nibble, 1, nibble, 0), 0x77);
}

TEST(Checksum, TheCrcMayBeInAnyByte) {
  Bytes last(8);
  last[0] = 0x10;
  EXPECT_EQ(autosar_profile1(0x123, DataIdMode::Nibble, 0, last, 7), 0x2A);
  last[7] = 0xA5;  // its own byte is no part of it
  EXPECT_EQ(autosar_profile1(0x123, DataIdMode::Nibble, 0, last, 7), 0x2A);
}

}  // namespace
}  // namespace eyebridge::bridges::dbc
