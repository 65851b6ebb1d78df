#include "eyebridge/hal/url.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eyebridge::hal {
namespace {

using testing::HasSubstr;

std::string complaint(std::string_view text) {
  try {
    parse_backend_url(text, {"--hal"});
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(BackendUrl, IsAtLeastAScheme) {
  EXPECT_EQ(parse_backend_url("sim", {}), (BackendUrl{"sim", "", {}}));
  EXPECT_EQ(parse_backend_url("sim:", {}), (BackendUrl{"sim", "", {}}));
}

TEST(BackendUrl, HasARestAndOptions) {
  EXPECT_EQ(parse_backend_url("serial:/dev/ttyACM0?profile=io7&baud=115200", {}),
            (BackendUrl{"serial", "/dev/ttyACM0", {{"baud", "115200"}, {"profile", "io7"}}}));
  EXPECT_EQ(parse_backend_url("tcp:host:4711", {}), (BackendUrl{"tcp", "host:4711", {}}));
  EXPECT_EQ(parse_backend_url("can:can0?node=", {}), (BackendUrl{"can", "can0", {{"node", ""}}}));
}

TEST(BackendUrl, KeepsAnEqualsSignInAValue) {
  EXPECT_EQ(parse_backend_url("sim?a=b=c", {}).options.at("a"), "b=c");
}

TEST(BackendUrl, RefusesABadScheme) {
  EXPECT_EQ(complaint(""), "--hal: found '', expected a URL such as sim or serial:DEVICE");
  EXPECT_THAT(complaint(":rest"), HasSubstr("found ':rest'"));
  EXPECT_THAT(complaint("Sim"), HasSubstr("found 'Sim'"));
  EXPECT_THAT(complaint("si m"), HasSubstr("found 'si m'"));
  EXPECT_THAT(complaint("?a=b"), HasSubstr("found '?a=b'"));
}

TEST(BackendUrl, RefusesBadOptions) {
  EXPECT_EQ(complaint("sim?fast"), "--hal: found the option 'fast', expected key=value");
  EXPECT_THAT(complaint("sim?"), HasSubstr("found the option ''"));
  EXPECT_THAT(complaint("sim?=1"), HasSubstr("found the option '=1'"));
  EXPECT_THAT(complaint("sim?a=1&"), HasSubstr("found the option ''"));
  EXPECT_EQ(complaint("sim?a=1&a=2"), "--hal: found the option 'a' twice");
}

}  // namespace
}  // namespace eyebridge::hal
