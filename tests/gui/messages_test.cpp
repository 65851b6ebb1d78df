#include "code/messages.hpp"

#include <ostream>
#include <string>

#include <gtest/gtest.h>

namespace eyebridge::gui {
namespace {

using Severity = Message::Severity;

struct MessageRow {
  const char* output;
  const char* file;
  int line;
  int column;
  Severity severity;
};

void PrintTo(const MessageRow& row, std::ostream* out) { *out << row.output; }

class Messages : public ::testing::TestWithParam<MessageRow> {};

TEST_P(Messages, PlaceIsFound) {
  const MessageRow& row = GetParam();
  const auto message = find_message(row.output);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->file, row.file);
  EXPECT_EQ(message->line, row.line);
  EXPECT_EQ(message->column, row.column);
  EXPECT_EQ(message->severity, row.severity);
  EXPECT_NE(
      std::string(row.output).substr(message->begin, message->end - message->begin).find(row.file),
      std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    All, Messages,
    ::testing::Values(
        MessageRow{"prog.c:4:29: error: expected ';' before 'while'", "prog.c", 4, 29,
                   Severity::Error},
        MessageRow{"/home/a b/my prog.c:4:29: warning: unused", "/home/a b/my prog.c", 4, 29,
                   Severity::Warning},
        MessageRow{"prog.c:7:3: note: in expansion of macro 'X'", "prog.c", 7, 3, Severity::Note},
        MessageRow{"prog.c:12: undefined reference to `VWStraigt'", "prog.c", 12, 0,
                   Severity::Error},
        MessageRow{"/usr/bin/ld: /tmp/p q.c:12: undefined reference to `f'", "/tmp/p q.c", 12, 0,
                   Severity::Error},
        MessageRow{"In file included from prog.c:1:", "prog.c", 1, 0, Severity::Note},
        MessageRow{"                 from ../lib/x.h:3,", "../lib/x.h", 3, 0, Severity::Note},
        MessageRow{"prog: prog.c:12: main: Assertion `x > 0' failed.", "prog.c", 12, 0,
                   Severity::Error},
        MessageRow{"  File \"/home/a b/walk.py\", line 4, in walk", "/home/a b/walk.py", 4, 0,
                   Severity::Error},
        MessageRow{"  File \"walk.py\", line 3", "walk.py", 3, 0, Severity::Error},
        MessageRow{"eyebridge: maze.maz:14:7: wall ends outside the map", "maze.maz", 14, 7,
                   Severity::Error},
        MessageRow{"worlds/a.wld:2:10: found 'x', expected a number", "worlds/a.wld", 2, 10,
                   Severity::Error},
        MessageRow{"    #1 0x55d in main /tmp/prog.c:12:3", "/tmp/prog.c", 12, 3, Severity::Error},
        MessageRow{"terminated at (prog.cpp:31)", "prog.cpp", 31, 0, Severity::Error}));

TEST(Messages, MostLinesNameNoPlace) {
  for (const char* const output :
       {"", ":", "front 120 mm", "12:30:05 started", "wall at 3:5", "see http://localhost:8080/x",
        "ratio a:1", "x.5:3", "File \"<stdin>\", line 1", "prog.c: in function 'main':", "prog.c:",
        "prog.c:0: nothing", "prog.c:99999999999999999999: nothing", "prog.c:12x",
        "<command-line>:1:2: error", "File \"\", line 3", "/:12: x", ".c:1: x"}) {
    EXPECT_FALSE(find_message(output)) << output;
  }
}

TEST(Messages, TextIsWhatWasSaid) {
  EXPECT_EQ(find_message("a.c:4:29: error: expected ';'")->text, "error: expected ';'");
  EXPECT_EQ(find_message("a.c:4: x")->text, "x");
  EXPECT_EQ(find_message("In file included from a.c:1:")->text, "");
}

}  // namespace
}  // namespace eyebridge::gui
