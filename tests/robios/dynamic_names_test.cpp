// What a program asks of the dynamic linker, by binutils' own word.
#include "dynamic_names.hpp"

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

#include "run_program.hpp"

namespace eyebridge::robios {
namespace {

using ::testing::Contains;
using ::testing::Not;
using ::testing::SizeIs;

const std::string kPrograms = EYEBRIDGE_TEST_PROGRAMS;

std::string bytes_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// "printf" of "printf@GLIBC_2.2.5 (2)".
std::set<std::string> undefined_by_nm(const std::string& file) {
  const testing::ProgramRun nm = testing::run_program(
      {{"/usr/bin/nm", "-D", "--undefined-only", "--format=just-symbols", file}, {}, ""});
  std::set<std::string> names;
  std::istringstream lines(nm.out);
  for (std::string line; std::getline(lines, line);) names.insert(line.substr(0, line.find('@')));
  return names;
}

TEST(DynamicNames, WantedNamesAreThoseOfNm) {
  for (const char* program :
       {"several", "several_options", "several_last_words", "several_crowd"}) {
    const std::string file = kPrograms + "/" + program;
    const std::string bytes = bytes_of(file);
    const auto names = dynamic_names(bytes);
    ASSERT_TRUE(names) << file;
    const std::set<std::string> wanted(names->wanted.begin(), names->wanted.end());
    EXPECT_EQ(wanted, undefined_by_nm(file));
    EXPECT_THAT(wanted, Not(SizeIs(0)));
    EXPECT_THAT(names->libraries, Contains("libc.so.6"));
  }
}

TEST(DynamicNames, WhatIsCutOffAnywhereIsReadAsFarAsItGoes) {
  const std::string file = bytes_of(kPrograms + "/several");
  for (std::size_t size = 0; size < file.size(); size += 97) {
    const std::string_view part = std::string_view(file).substr(0, size);
    const auto names = dynamic_names(part);
    if (!names) continue;
    for (const std::string_view name : names->wanted) EXPECT_NE(part.find(name), part.npos) << size;
  }
  EXPECT_FALSE(dynamic_names("#!/usr/bin/python3"));
  EXPECT_FALSE(dynamic_names(""));
}

}  // namespace
}  // namespace eyebridge::robios
