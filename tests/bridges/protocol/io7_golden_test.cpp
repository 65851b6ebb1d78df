#include <string>

#include <gmock/gmock.h>

#include "eyebridge/bridges/io7/reply_parser.hpp"
#include "eyebridge/bridges/io7/request.hpp"
#include "golden.hpp"

namespace eyebridge::bridges::io7 {
namespace {

using test::golden_lines;

struct Row {
  std::string kind, form;
  char letter;
  std::vector<std::string> words;  ///< Arguments or values.
  std::vector<std::uint8_t> bytes;
  std::string line;
};

std::vector<Row> rows(const std::string& kind) {
  std::vector<Row> found;
  for (const auto& words : golden_lines("io7.hex")) {
    if (words[0] != kind) continue;
    Row row{words[0], words[1], words[2][0], {}, {}, ""};
    std::string hex;
    bool data = false;
    for (std::size_t i = 3; i < words.size(); ++i) {
      if (words[i] == ":") {
        data = true;
      } else if (data) {
        hex += words[i];
      } else {
        row.words.push_back(words[i]);
      }
    }
    row.bytes = test::bytes_from_hex(hex);
    for (const auto& word : words) row.line += word + " ";
    found.push_back(std::move(row));
  }
  return found;
}

Request request_of(const Row& row) {
  Request request{.letter = row.letter};
  for (const std::string& word : row.words) {
    const bool is_letter = std::string("ioIJ").find(word[0]) != std::string::npos;
    request.arguments[request.count++] = is_letter ? word[0] : std::stoi(word);
  }
  return request;
}

ReplyParser parse(const Row& row) {
  ReplyParser parser;
  parser.start(Request{.letter = row.letter}, test::profile_of(row.form));
  for (const std::uint8_t byte : row.bytes) parser.push(byte);
  return parser;
}

TEST(Io7Golden, EveryRequestIsWrittenAsInTheFile) {
  const auto all = rows("request");
  EXPECT_GT(all.size(), 40U);
  for (const Row& row : all) {
    const auto bytes = encode(request_of(row), test::profile_of(row.form));
    ASSERT_TRUE(bytes) << row.line << bytes.error().what;
    EXPECT_THAT(bytes->view(), testing::ElementsAreArray(row.bytes)) << row.line;
  }
}

TEST(Io7Golden, EveryRequestIsReadBack) {
  for (const Row& row : rows("request")) {
    const auto request = decode_request(row.bytes, test::profile_of(row.form));
    ASSERT_TRUE(request) << row.line << request.error().what;
    EXPECT_EQ(*request, request_of(row)) << row.line;
  }
}

TEST(Io7Golden, EveryLetterThatMayBeSentIsInTheFile) {
  LetterSet letters;
  for (const Row& row : rows("request")) letters.insert(row.letter);
  for (const Command& command : commands()) {
    const bool has_arguments = command.argument_count > 0 || command.documented;
    EXPECT_TRUE(letters.has(command.letter) || !has_arguments) << command.letter;
  }
}

TEST(Io7Golden, EveryReplyIsReadAsInTheFile) {
  const auto all = rows("reply");
  EXPECT_GT(all.size(), 30U);
  for (const Row& row : all) {
    const ReplyParser parser = parse(row);
    const auto reply = parser.reply();
    ASSERT_TRUE(reply) << row.line << reply.error().what;
    EXPECT_EQ(parser.stray(), 0U) << row.line;
    if (row.letter == IO7_VERSION) {
      EXPECT_EQ(std::string(reply->version.begin(), reply->version.end()), row.words[0]);
      continue;
    }
    ASSERT_EQ(reply->count, row.words.size()) << row.line;
    for (std::size_t i = 0; i < row.words.size(); ++i) {
      EXPECT_EQ(reply->values[i], std::stoi(row.words[i])) << row.line;
    }
  }
}

TEST(Io7Golden, EveryCorruptReplyIsRefused) {
  const auto all = rows("corrupt");
  EXPECT_GT(all.size(), 10U);
  for (const Row& row : all) {
    const auto reply = parse(row).reply();
    ASSERT_FALSE(reply) << row.line;
    EXPECT_EQ(reply.error().code, Errc::Corrupt) << row.line;
  }
}

TEST(Io7Golden, NoReplyIsCompleteBeforeItsLastByte) {
  for (const Row& row : rows("reply")) {
    if (row.form == "text") continue;  // CR may or may not be followed by LF
    ReplyParser parser;
    parser.start(Request{.letter = row.letter}, test::profile_of(row.form));
    for (std::size_t i = 0; i + 1 < row.bytes.size(); ++i) {
      EXPECT_EQ(parser.push(row.bytes[i]), ReplyParser::State::Waiting) << row.line;
    }
  }
}

}  // namespace
}  // namespace eyebridge::bridges::io7
