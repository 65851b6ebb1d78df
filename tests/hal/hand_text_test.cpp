// What the setting `drive` says.
#include "hand/hand_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

using ::testing::HasSubstr;

TEST(HandText, NamesAPersonWithOrWithoutMarkers) {
  EXPECT_EQ(parse_hand("hand", {}), HandSetting{});
  EXPECT_TRUE(parse_hand("hand:free", {}).is_free);
}

TEST(HandText, TakesTheSheetsLayoutInAnyUnitOfLength) {
  const HandSetting setting = parse_hand("hand?size=60mm&spacing=0.4&height=10cm&fov=66", {});
  EXPECT_NEAR(setting.layout.size, 0.06, 1e-12);
  EXPECT_NEAR(setting.layout.spacing, 0.4, 1e-12);
  EXPECT_NEAR(setting.layout.height, 0.1, 1e-12);
  EXPECT_NEAR(setting.field_of_view.value(), deg_to_rad(66), 1e-12);
  EXPECT_EQ(parse_hand("hand?family=tag25h9", {}).layout.family, camera::FiducialFamily::Tag25h9);
}

TEST(HandText, SaysWhatIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {"feet", "found 'feet', expected hand or hand:free"},
      {"hand:held", "found 'hand:held', expected hand or hand:free"},
      {"hand:free?size=1", "found the option 'size', expected none"},
      {"hand?colour=red",
       "unknown option 'colour', expected one of size, spacing, height, family, fov"},
      {"hand?family=tag", "found family='tag', expected aruco, tag36h11, tag25h9 or tag16h5"},
      {"hand?size=big", "found size='big', expected a length up to 100 m, such as 80mm"},
      {"hand?size=-1mm", "expected a length"},
      {"hand?size=nan", "expected a length"},
      {"hand?size=1e9", "expected a length"},
      {"hand?size=8in", "expected a length"},
      {"hand?fov=180", "found fov='180', expected the camera's angle of view"},
      {"hand?fov=60deg", "found fov='60deg'"},
  };
  for (const auto& [text, message] : cases) {
    try {
      parse_hand(text, {"--drive"});
      ADD_FAILURE() << text;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr(std::string("--drive: "))) << text;
      EXPECT_THAT(error.what(), HasSubstr(message)) << text;
    }
  }
}

}  // namespace
}  // namespace eyebridge::hal
