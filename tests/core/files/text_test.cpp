#include <gmock/gmock.h>

#include "reading.hpp"

namespace eyebridge::files {
namespace {

using testing::HasSubstr;

std::string text_error(const std::filesystem::path& path) {
  return error_of([&] { read_text_file(path); });
}

TEST(TextFile, IsReadWhole) {
  const Folder folder;
  EXPECT_EQ(read_text_file(folder.write("a", "x\r\ny")), "x\ny");
  EXPECT_EQ(read_text_file(folder.write("b", "")), "");
}

TEST(TextFile, MissingFilesFoldersAndDevicesAreErrors) {
  const Folder folder;
  EXPECT_THAT(text_error(folder.path() / "no"), HasSubstr("no: no such file"));
  EXPECT_THAT(text_error(folder.path()), HasSubstr("is not a file: expected a text file"));
  EXPECT_THAT(text_error("/dev/zero"), HasSubstr("is not a file: expected a text file"));
}

TEST(TextFile, AHugeFileIsRefusedBeforeItIsRead) {
  const Folder folder;
  const auto path = folder.write("huge.wld", "");
  std::filesystem::resize_file(path, 1ULL << 30U);  // a hole: takes no room on the disk
  EXPECT_EQ(text_error(path), path.string() + ": has 1073741824 bytes, expected at most 67108864");
}

TEST(TextFile, BinaryJunkIsOneError) {
  const Folder folder;
  const auto path = folder.write("junk.wld", std::string("floor 9 9\n0 \0 1", 15));
  EXPECT_EQ(text_error(path), path.string() + ":2:3: byte 0 found: expected a text file");
}

TEST(TextFile, AnEndlessLineIsOneError) {
  const Folder folder;
  const auto path = folder.write("long.wld", std::string(100000, '1'));
  EXPECT_EQ(text_error(path),
            path.string() + ":1:65537: line is too long: expected at most 65536 bytes");
}

}  // namespace
}  // namespace eyebridge::files
