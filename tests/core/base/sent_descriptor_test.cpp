#include "eyebridge/base/sent_descriptor.hpp"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

namespace eyebridge {
namespace {

class SentDescriptor : public ::testing::Test {
 protected:
  SentDescriptor() {
    int ends[2];
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends), 0);
    near_.reset(ends[0]);
    far_.reset(ends[1]);
  }
  UniqueFd near_;
  UniqueFd far_;
  const std::array<std::byte, 3> words_{std::byte{1}, std::byte{2}, std::byte{3}};
  std::array<std::byte, 8> room_{};
};

TEST_F(SentDescriptor, IsTheSameFileForTheReceiver) {
  int ends[2];
  ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
  const UniqueFd reading(ends[0]);
  UniqueFd writing(ends[1]);
  ASSERT_EQ(send_with_descriptor(near_.get(), words_, writing.get()), 3);
  writing.reset();
  UniqueFd came;
  ASSERT_EQ(receive_with_descriptor(far_.get(), room_, came), 3);
  EXPECT_EQ(room_[2], std::byte{3});
  ASSERT_TRUE(came.valid());
  EXPECT_EQ(::fcntl(came.get(), F_GETFD), FD_CLOEXEC);
  ASSERT_EQ(::write(came.get(), "x", 1), 1);
  char read = 0;
  EXPECT_EQ(::read(reading.get(), &read, 1), 1);
  EXPECT_EQ(read, 'x');
}

TEST_F(SentDescriptor, WordsMayComeWithoutOne) {
  ASSERT_EQ(send_with_descriptor(near_.get(), words_, -1), 3);
  UniqueFd came(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  EXPECT_EQ(receive_with_descriptor(far_.get(), room_, came), 3);
  EXPECT_FALSE(came.valid());
}

TEST_F(SentDescriptor, AnEndThatIsGoneIsAnError) {
  far_.reset();
  EXPECT_EQ(send_with_descriptor(near_.get(), words_, -1), -1);
  EXPECT_EQ(errno, EPIPE);
  UniqueFd came;
  EXPECT_EQ(receive_with_descriptor(near_.get(), room_, came), 0);
}

}  // namespace
}  // namespace eyebridge
