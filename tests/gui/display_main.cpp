// Tests at a display: Xvfb's, unless this process has one.

#include <QApplication>
#include <QFont>
#include <QStyle>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace {

bool lists_only(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::strncmp(argv[i], "--gtest_list_tests", 18) == 0) return true;
  }
  return false;
}

/// Becomes xvfb-run with this program.
[[noreturn]] void take_display(int argc, char** argv) {
  const std::string self = "/proc/" + std::to_string(getpid()) + "/exe";
  std::vector<char> file(4096, '\0');
  if (readlink(self.c_str(), file.data(), file.size() - 1) < 0) std::exit(1);
  std::vector<std::string> words{"xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", file.data()};
  words.insert(words.end(), argv + 1, argv + argc);
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  execvp(all[0], all.data());
  perror("xvfb-run (Debian: xvfb, xauth)");
  std::exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  // First: GoogleTest takes its words away.
  const bool lists = lists_only(argc, argv);
  if (!lists && std::getenv("DISPLAY") == nullptr) take_display(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  if (lists) return RUN_ALL_TESTS();
  // Neither what a person has set, nor leave anything behind.
  const std::string folder = "/tmp/eyebridge-gui-test-" + std::to_string(getpid());
  setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
  const char* const scale = std::getenv("EYEBRIDGE_TEST_SCALE");  // of the display: high_dpi_test
  setenv("QT_SCALE_FACTOR", scale == nullptr ? "1" : scale, 1);
  int result = 0;
  {
    const QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    // Pictures are compared: not as somebody's desktop has it.
    QApplication::setStyle("Fusion");
    QApplication::setPalette(QApplication::style()->standardPalette());
    QApplication::setFont(QFont("DejaVu Sans", 9));
    result = RUN_ALL_TESTS();
  }
  static_cast<void>(std::system(("rm -rf " + folder).c_str()));
  return result;
}
