#include <gtest/gtest.h>

extern "C" {
int width_seen_in_unit_one(void);
int width_seen_in_unit_two(void);
int things_only_eyebot_brings(const char* text);
int free_names_in_use(void);
int redefined_front(void);
}
int c_header_first();
int cpp_header_first();
int wrapped_header();

namespace {

TEST(Header, TwoSourcesOfOneProgramShareItsVariables) {
  EXPECT_EQ(width_seen_in_unit_one(), 17);
  EXPECT_EQ(width_seen_in_unit_two(), 17);
}

TEST(Header, BringsWhatProgramsDoNotIncludeThemselves) {
  EXPECT_EQ(things_only_eyebot_brings("42"), 0);
}

TEST(Header, LeavesProgramsTheirNames) { EXPECT_EQ(free_names_in_use(), 42); }

TEST(Header, LetsProgramsRenumberTheSensors) { EXPECT_EQ(redefined_front(), 21); }

TEST(Header, WorksInEveryOrderAndInsideExternC) {
  EXPECT_EQ(c_header_first(), 560);
  EXPECT_EQ(cpp_header_first(), 163);
  EXPECT_EQ(wrapped_header(), 8);
}

}  // namespace
