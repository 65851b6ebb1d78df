// From an HDT file to what the devices of a board need.
#include "board/board_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.hpp"

namespace eyebridge::hal {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::IsEmpty;

class BoardTablesOfHdt : public ::testing::Test {
 protected:
  BoardTables read(const std::string& text) {
    return read_board_tables(folder_.write("hdt.txt", text), warnings_);
  }
  std::string refusal(const std::string& text) {
    try {
      read(text);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  std::vector<Warning> warnings_;
  eyebridge::testing::ScratchFolder folder_;
};

TEST_F(BoardTablesOfHdt, HoldWhatTheFileListsAndNothingElse) {
  const BoardTables tables = read(
      "MOTOR 3\nSERVO 2 700 1500\nPSD 6 near\nTABLE near\n80 500 9999 20000\nEND TABLE\n"
      "ENCODER 1 10000\nENCODER 2 9900\nDRIVE 95 40 0 1\n");
  ASSERT_EQ(tables.motors.size(), 1u);
  EXPECT_EQ(tables.motors[0].id, 3);
  EXPECT_THAT(tables.motors[0].duty, IsEmpty());
  ASSERT_EQ(tables.servos.size(), 1u);
  EXPECT_EQ(tables.servos[0].id, 2);
  EXPECT_EQ(tables.servos[0].lower_10us, 70);
  EXPECT_EQ(tables.servos[0].upper_10us, 150);
  ASSERT_EQ(tables.psds.size(), 1u);
  EXPECT_EQ(tables.psds[0].id, 6);
  EXPECT_THAT(tables.psds[0].metres, ElementsAre(0.08, 0.5, kBoardOutOfRange, kBoardOutOfRange));
  EXPECT_THAT(tables.encoders, ElementsAre(1, 2));
  EXPECT_DOUBLE_EQ(tables.drive.wheel_base, 0.095);
  EXPECT_DOUBLE_EQ(tables.drive.max_linear, 0.4);
  EXPECT_DOUBLE_EQ(tables.drive.left_ticks_per_metre, 10000);
  EXPECT_DOUBLE_EQ(tables.drive.right_ticks_per_metre, 9900);
  EXPECT_FALSE(tables.drive.left_reversed);
  EXPECT_TRUE(tables.drive.right_reversed);
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(BoardTablesOfHdt, WithoutADriveTheWheelsAreThoseOfAnS4AndThatIsSaid) {
  const BoardTables tables = read("ENCODER 2 9900\n");
  EXPECT_DOUBLE_EQ(tables.drive.wheel_base, BoardDriveShape{}.wheel_base);
  EXPECT_DOUBLE_EQ(tables.drive.left_ticks_per_metre, BoardDriveShape{}.left_ticks_per_metre);
  EXPECT_DOUBLE_EQ(tables.drive.right_ticks_per_metre, 9900);
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_THAT(warnings_[0].str(), EndsWith("/hdt.txt: warning: no DRIVE line: expected one; the "
                                           "wheels count as an S4's"));
}

TEST_F(BoardTablesOfHdt, RefuseADriveThatABoardCannotHave) {
  EXPECT_THAT(refusal("ENCODER 1 100\nDRIVE 95 40 0 1\n"),
              EndsWith("hdt.txt:2:1: DRIVE without ENCODER 2: expected its ticks per metre"));
  EXPECT_THAT(refusal("MOTOR \"m\" 1 9\nENCODER \"e\" 1 9 9 \"m\"\n"
                      "DRIVE \"d\" ACKERMANN 9 9 9 \"e\" \"e\"\n"),
              EndsWith("hdt.txt:3:1: found another drive than a differential one, expected two "
                       "wheels"));
  EXPECT_THAT(refusal("MOTOR \"r\" 1 9\nMOTOR \"l\" 2 9\n"
                      "ENCODER \"er\" 1 9 9 \"r\"\nENCODER \"el\" 2 9 9 \"l\"\n"
                      "DRIVE \"d\" DIFFERENTIAL 90 \"el\" \"er\"\n"),
              EndsWith("hdt.txt:5:1: found encoder 2 on motor 2 at the left wheel, expected "
                       "encoder and motor 1"));
}

TEST_F(BoardTablesOfHdt, AreThoseOfANamedDriveWhoseWheelsAreWhereABoardHasThem) {
  const BoardTables tables = read(
      "MOTOR \"l\" 1 9\nMOTOR \"r\" 2 9\n"
      "ENCODER \"el\" 1 9 9 \"l\"\nENCODER \"er\" 2 8 9 \"r\"\n"
      "DRIVE \"d\" DIFFERENTIAL 90 \"el\" \"er\"\n");
  EXPECT_DOUBLE_EQ(tables.drive.left_ticks_per_metre, 9);
  EXPECT_DOUBLE_EQ(tables.drive.right_ticks_per_metre, 8);
  EXPECT_DOUBLE_EQ(tables.drive.max_linear, BoardDriveShape{}.max_linear);
}

TEST_F(BoardTablesOfHdt, RefuseWhatIsNoFile) {
  EXPECT_THAT([&] { read_board_tables("/dev/zero", warnings_); },
              ::testing::ThrowsMessage<ConfigError>(
                  ::testing::StrEq("/dev/zero: is not a file: expected a text file")));
}

}  // namespace
}  // namespace eyebridge::hal
