#include "eyebridge/base/url.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eyebridge {
namespace {

using testing::HasSubstr;

std::string complaint(std::string_view text) {
  try {
    parse_url(text, {"--hal"});
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(Url, IsAtLeastAScheme) {
  EXPECT_EQ(parse_url("sim", {}), (Url{"sim", "", {}}));
  EXPECT_EQ(parse_url("sim:", {}), (Url{"sim", "", {}}));
}

TEST(Url, HasARestAndOptions) {
  EXPECT_EQ(parse_url("serial:/dev/ttyACM0?profile=io7&baud=115200", {}),
            (Url{"serial", "/dev/ttyACM0", {{"baud", "115200"}, {"profile", "io7"}}}));
  EXPECT_EQ(parse_url("tcp:host:4711", {}), (Url{"tcp", "host:4711", {}}));
  EXPECT_EQ(parse_url("can:can0?node=", {}), (Url{"can", "can0", {{"node", ""}}}));
}

TEST(Url, KeepsAnEqualsSignInAValue) {
  EXPECT_EQ(parse_url("sim?a=b=c", {}).options.at("a"), "b=c");
}

TEST(Url, RefusesABadScheme) {
  EXPECT_EQ(complaint(""), "--hal: found '', expected a URL such as sim or serial:DEVICE");
  EXPECT_THAT(complaint(":rest"), HasSubstr("found ':rest'"));
  EXPECT_THAT(complaint("Sim"), HasSubstr("found 'Sim'"));
  EXPECT_THAT(complaint("si m"), HasSubstr("found 'si m'"));
  EXPECT_THAT(complaint("?a=b"), HasSubstr("found '?a=b'"));
}

TEST(Url, RefusesBadOptions) {
  EXPECT_EQ(complaint("sim?fast"), "--hal: found the option 'fast', expected key=value");
  EXPECT_THAT(complaint("sim?"), HasSubstr("found the option ''"));
  EXPECT_THAT(complaint("sim?=1"), HasSubstr("found the option '=1'"));
  EXPECT_THAT(complaint("sim?a=1&"), HasSubstr("found the option ''"));
  EXPECT_EQ(complaint("sim?a=1&a=2"), "--hal: found the option 'a' twice");
}

}  // namespace
}  // namespace eyebridge
