// What the editor offers is what the headers and the module eye declare.
#include "code/completions.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.hpp"

namespace eyebridge::gui {
namespace {

namespace fs = std::filesystem;
using eyebridge::testing::file_text;
using ::testing::HasSubstr;

const fs::path kSource = EYEBRIDGE_SOURCE_DIR;

/// The functions of both references, by hand, in tests/compatibility.
std::set<std::string> functions_of(const std::string& generation) {
  std::ifstream file(kSource / "tests/compatibility/functions.txt");
  std::set<std::string> names;
  std::string line;
  bool in_part = false;
  while (std::getline(file, line)) {
    if (line.starts_with('[')) in_part = line == "[" + generation + "]";
    const std::size_t colon = line.find(':');
    if (!in_part || line.starts_with('#') || colon == line.npos) continue;
    std::istringstream words(line.substr(colon + 1));
    names.insert(std::istream_iterator<std::string>(words), {});
  }
  return names;
}

/// All that the headers in a folder have.
std::string headers_in(const fs::path& folder) {
  std::string all;
  for (const auto& entry : fs::directory_iterator(folder)) all += file_text(entry.path());
  return all;
}

void expect_all_offered(Api api, const std::string& generation, const fs::path& folder) {
  const std::string headers = headers_in(folder);
  int count = 0;
  for (const std::string& name : functions_of(generation)) {
    // Some are exported for old programs, and declared nowhere.
    if (headers.find(" " + name + "(") == headers.npos &&
        headers.find("(" + name + ")(") == headers.npos &&
        headers.find("*" + name + "(") == headers.npos &&
        headers.find("* " + name + "(") == headers.npos) {
      continue;
    }
    const Completion* const found = find_completion(api, name);
    ASSERT_NE(found, nullptr) << name;
    EXPECT_EQ(found->kind, Completion::Kind::Function) << name;
    EXPECT_THAT(found->prototype, HasSubstr(name + "("));
    ++count;
  }
  EXPECT_GT(count, 100);
}

TEST(Completions, EveryFunctionOfEyebotIsOffered) {
  expect_all_offered(Api::Robios7, "RoBIOS-7", kSource / "robios/include/eyebridge_robios");
}

TEST(Completions, EveryFunctionOfClassicRobiosIsOffered) {
  expect_all_offered(Api::Classic, "classic", kSource / "robios/include/classic/eyebridge_classic");
}

TEST(Completions, EveryFunctionOfEyeIsOffered) {
  std::istringstream stub(file_text(kSource / "python/eye/__init__.pyi"));
  std::string line;
  int count = 0;
  while (std::getline(stub, line)) {
    if (!line.starts_with("def ")) continue;
    const std::string name = line.substr(4, line.find('(') - 4);
    const Completion* const found = find_completion(Api::Python, name);
    ASSERT_NE(found, nullptr) << name;
    EXPECT_TRUE(*found->doc != 0 || name == "EYEBRIDGELastError") << name;
    ++count;
  }
  EXPECT_GT(count, 100);
}

TEST(Completions, PrototypesAndSentencesAreThoseOfTheHeaders) {
  EXPECT_STREQ(find_completion(Api::Robios7, "VWStraight")->prototype,
               "int VWStraight(int dist, int lin_speed)");
  EXPECT_STREQ(find_completion(Api::Robios7, "VWStraight")->doc,
               "Drives dist mm straight on; backwards when dist is negative.");
  EXPECT_STREQ(find_completion(Api::Robios7, "VWRemain")->prototype, "int VWRemain()");
  EXPECT_STREQ(find_completion(Api::Robios7, "OSAttachTimer")->prototype,
               "TIMER OSAttachTimer(int scale, void (*fct)(void))");
  EXPECT_STREQ(find_completion(Api::Classic, "VWInit")->prototype,
               "VWHandle VWInit(DeviceSemantics semantics, int Timescale)");
  EXPECT_STREQ(find_completion(Api::Python, "VWGetPosition")->prototype,
               "VWGetPosition(x=..., y=..., phi=...) -> list[int]");
  EXPECT_EQ(find_completion(Api::Robios7, "PSD_FRONT")->kind, Completion::Kind::Constant);
  EXPECT_EQ(find_completion(Api::Robios7, "CAMWIDTH")->kind, Completion::Kind::Variable);
  EXPECT_EQ(find_completion(Api::Robios7, "COLOR")->kind, Completion::Kind::Type);
  EXPECT_EQ(find_completion(Api::Robios7, "VWInit"), nullptr);
  EXPECT_EQ(find_completion(Api::Robios7, "EYEBRIDGESend"), nullptr) << "a helper behind a macro";
}

TEST(Completions, AreInOrder) {
  for (const Api api : {Api::Robios7, Api::Classic, Api::Python}) {
    EXPECT_TRUE(std::ranges::is_sorted(completions(api), {},
                                       [](const Completion& c) { return std::string(c.name); }));
  }
}

TEST(Completions, ClassicProgramsAreToldFromOthers) {
  int count = 0;
  for (const auto& [folder, classic] : {std::pair{"classic", true}, std::pair{"c", false}}) {
    for (const auto& entry : fs::directory_iterator(kSource / "tests/gallery" / folder)) {
      const std::string text = entry.is_regular_file() ? file_text(entry.path()) : "";
      if (text.find("eyebot") == text.npos) continue;
      EXPECT_EQ(is_classic(text), classic) << entry.path();
      ++count;
    }
  }
  EXPECT_GT(count, 40);
  EXPECT_TRUE(is_classic("#include <hdt_sem.h>\nint main() {}\n"));
  EXPECT_FALSE(is_classic(
      "// VWInit(VW_DRIVE, 1)\n/* OSMTInit(COOP) */ char* s = \"PSDInit(3)\"; VWTurn(1, 2);"));
  EXPECT_FALSE(is_classic(""));
  EXPECT_FALSE(is_classic("\"unclosed \\"));
}

}  // namespace
}  // namespace eyebridge::gui
