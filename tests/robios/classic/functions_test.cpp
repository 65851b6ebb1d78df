// Every function of the manuals (functions.txt) is declared, documented and in the library.

#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

const fs::path kHeaders = fs::path(EYEBRIDGE_SOURCE_DIR) / "robios/include/classic";

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> functions() {
  return lines_of(fs::path(EYEBRIDGE_SOURCE_DIR) / "tests/robios/classic/functions.txt");
}

/// The functions that a header declares, with whether a comment stands over the declaration, or over
/// the group of declarations without an empty line that it is in.
std::map<std::string, bool> declarations(const fs::path& header) {
  std::map<std::string, bool> found;
  bool documented = false;
  bool in_comment = false;
  for (const std::string& line : lines_of(header)) {
    if (line.find("/*") == 0 || in_comment) {
      in_comment = line.find("*/") == std::string::npos;
      documented = true;
      continue;
    }
    if (line.empty()) {
      documented = false;
      continue;
    }
    const std::size_t open = line.find('(');
    if (open == std::string::npos || line.front() == ' ' || line.front() == '#') continue;
    std::size_t end = open;
    if (line.compare(0, 4, "int(") == 0) end = line.find(')');
    std::size_t begin = end;
    while (begin > 0 && (std::isalnum(static_cast<unsigned char>(line[begin - 1])) != 0 ||
                         line[begin - 1] == '_')) {
      --begin;
    }
    found[line.substr(begin, end - begin)] = documented;
  }
  return found;
}

TEST(ClassicFunctions, AreAllDeclaredAndDocumented) {
  std::map<std::string, bool> declared;
  for (const auto& entry : fs::directory_iterator(kHeaders / "eyebridge_classic")) {
    declared.merge(declarations(entry.path()));
  }
  const std::vector<std::string> wanted = functions();
  EXPECT_GT(wanted.size(), 170U);
  for (const std::string& name : wanted) {
    ASSERT_TRUE(declared.contains(name)) << name << " is not declared";
    EXPECT_TRUE(declared[name]) << name << " has no comment";
  }
}

TEST(ClassicFunctions, AreAllInTheLibrary) {
  void* const library = dlopen(EYEBRIDGE_CLASSIC_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
  ASSERT_NE(library, nullptr) << dlerror();
  for (const std::string& name : functions()) {
    EXPECT_NE(dlsym(library, name.c_str()), nullptr) << name << " is not in the library";
  }
}

}  // namespace
