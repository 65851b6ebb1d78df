#include "machine/can_links.hpp"

#include <random>
#include <string>

#include <gmock/gmock.h>
#include <linux/can/netlink.h>
#include <linux/if_arp.h>
#include <linux/rtnetlink.h>

namespace eyebridge::apps {
namespace {

using ::testing::IsEmpty;

using Bytes = std::string;

Bytes padded(Bytes bytes) {
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
  return bytes;
}

template <class T>
Bytes bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

Bytes attribute(int type, const Bytes& payload) {
  const rtattr head{static_cast<unsigned short>(sizeof(rtattr) + payload.size()),
                    static_cast<unsigned short>(type)};
  return padded(bytes_of(head) + payload);
}

Bytes message(unsigned short type, const Bytes& payload) {
  nlmsghdr head{};
  head.nlmsg_len = static_cast<unsigned>(sizeof head + payload.size());
  head.nlmsg_type = type;
  return padded(bytes_of(head) + payload);
}

Bytes link(unsigned short hardware, const Bytes& attributes) {
  ifinfomsg info{};
  info.ifi_type = hardware;
  return message(RTM_NEWLINK, bytes_of(info) + attributes);
}

Bytes named(const std::string& name) { return attribute(IFLA_IFNAME, name + '\0'); }

Bytes u32(int type, std::uint32_t value) { return attribute(type, bytes_of(value)); }
Bytes u16(int type, std::uint16_t value) { return attribute(type, bytes_of(value)); }

std::vector<CanLink> read(const Bytes& answer) {
  return read_can_links({reinterpret_cast<const std::byte*>(answer.data()), answer.size()});
}

/// An adapter at 500 kbit/s that has gone off the bus, with everything that drivers tell.
Bytes adapter() {
  can_bittiming timing{};
  timing.bitrate = 500'000;
  can_bittiming data_timing{};
  data_timing.bitrate = 2'000'000;
  can_device_stats counts{};
  counts.bus_error = 7;
  counts.bus_off = 2;
  const Bytes data =
      attribute(IFLA_CAN_BITTIMING, bytes_of(timing)) +
      attribute(IFLA_CAN_DATA_BITTIMING, bytes_of(data_timing)) +
      u32(IFLA_CAN_STATE, CAN_STATE_BUS_OFF) + u32(IFLA_CAN_RESTART_MS, 0) +
      attribute(IFLA_CAN_BERR_COUNTER, bytes_of(can_berr_counter{248, 3})) +
      attribute(IFLA_CAN_CTRLMODE,
                bytes_of(can_ctrlmode{0xFF, CAN_CTRLMODE_LISTENONLY | CAN_CTRLMODE_FD})) +
      u16(IFLA_CAN_TERMINATION, 120);
  const Bytes info = attribute(IFLA_INFO_KIND, std::string("can") + '\0') +
                     attribute(IFLA_INFO_DATA | NLA_F_NESTED, data) +
                     attribute(IFLA_INFO_XSTATS, bytes_of(counts));
  return link(ARPHRD_CAN, named("can0") + attribute(IFLA_LINKINFO, info));
}

TEST(CanLinks, EverythingThatADriverTellsIsRead) {
  const auto links = read(adapter());
  ASSERT_EQ(links.size(), 1u);
  const CanLink& can0 = links[0];
  EXPECT_EQ(can0.name, "can0");
  EXPECT_EQ(can0.kind, "can");
  EXPECT_EQ(can0.state, BusState::BusOff);
  EXPECT_EQ(can0.bit_rate, 500'000u);
  EXPECT_EQ(can0.data_bit_rate, 2'000'000u);
  EXPECT_EQ(can0.restart_ms, 0u);
  EXPECT_EQ(can0.termination_ohm, 120);
  EXPECT_EQ(can0.send_errors, 248);
  EXPECT_EQ(can0.receive_errors, 3);
  EXPECT_EQ(can0.bus_errors, 7u);
  EXPECT_EQ(can0.bus_offs, 2u);
  EXPECT_TRUE(can0.listen_only);
  EXPECT_TRUE(can0.fd_on);
}

TEST(CanLinks, OtherInterfacesAndOtherMessagesAreSkipped) {
  const auto links = read(link(ARPHRD_ETHER, named("eth0")) + link(ARPHRD_CAN, named("vcan0")) +
                          message(NLMSG_DONE, std::string(4, '\0')));
  ASSERT_EQ(links.size(), 1u);
  EXPECT_EQ(links[0].name, "vcan0");
  EXPECT_FALSE(links[0].state);
  EXPECT_FALSE(links[0].bit_rate);
}

TEST(CanLinks, AStateThatIsNoneIsNotTold) {
  const Bytes info = attribute(IFLA_INFO_DATA, u32(IFLA_CAN_STATE, 77));
  const auto links = read(link(ARPHRD_CAN, named("can0") + attribute(IFLA_LINKINFO, info)));
  ASSERT_EQ(links.size(), 1u);
  EXPECT_FALSE(links[0].state);
}

TEST(CanLinks, AnAnswerThatIsCutOffAnywhereIsReadAsFarAsItGoes) {
  const Bytes whole = adapter() + adapter();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_LT(read(whole.substr(0, size)).size(), 2u) << size;
  }
  EXPECT_EQ(read(whole).size(), 2u);
}

TEST(CanLinks, DamagedAnswersAreNoDanger) {
  std::mt19937 random(7);  // NOLINT(cert-msc51-cpp): the same bytes each time
  const Bytes whole = adapter() + adapter();
  for (int round = 0; round < 20'000; ++round) {
    Bytes damaged = whole;
    for (int i = 0; i < 4; ++i) damaged[random() % damaged.size()] = static_cast<char>(random());
    EXPECT_LE(read(damaged).size(), 40u);
  }
  EXPECT_THAT(read(std::string(64, '\0')), IsEmpty()) << "a length of 0 would never end";
}

TEST(CanLinks, AskingThisKernelEnds) {
  for (const CanLink& link : ask_can_links()) EXPECT_FALSE(link.name.empty());
}

TEST(CanLinks, StatesHaveTheNamesThatLinuxToolsGiveThem) {
  EXPECT_STREQ(name_of(BusState::ErrorActive), "error-active");
  EXPECT_STREQ(name_of(BusState::ErrorPassive), "error-passive");
  EXPECT_STREQ(name_of(BusState::BusOff), "bus-off");
}

}  // namespace
}  // namespace eyebridge::apps
