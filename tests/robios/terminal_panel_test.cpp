#include "terminal/terminal_panel.hpp"

#include <string>

#include <fcntl.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "terminal_expect.hpp"

namespace eyebridge::robios {
namespace {

using testing::TerminalEmulator;

/// A window whose program is the test.
class Window {
 public:
  Window(int columns, int rows) : screen(columns, rows) {
    winsize size{};
    size.ws_col = static_cast<unsigned short>(columns);
    size.ws_row = static_cast<unsigned short>(rows);
    EXPECT_EQ(openpty(&master_, &slave_, nullptr, nullptr, &size), 0);
    fcntl(master_, F_SETFL, O_NONBLOCK);
  }
  ~Window() {
    close(master_);
    close(slave_);
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  [[nodiscard]] UniqueFd terminal() const { return UniqueFd(dup(slave_)); }
  void print(const std::string& text) const {
    EXPECT_EQ(write(slave_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void resize(int columns, int rows) {
    show();
    winsize size{};
    size.ws_col = static_cast<unsigned short>(columns);
    size.ws_row = static_cast<unsigned short>(rows);
    EXPECT_EQ(ioctl(slave_, TIOCSWINSZ, &size), 0);
    screen.resize(columns, rows);
  }
  /// Takes what was printed and drawn to the screen.
  void show() {
    char bytes[4096];
    for (ssize_t count = 0; (count = read(master_, bytes, sizeof bytes)) > 0;) {
      screen.feed({bytes, static_cast<std::size_t>(count)});
    }
  }
  void expect_shows(const Lcd& lcd, ColourDepth depth = ColourDepth::True) {
    show();
    const ScreenShot shot = lcd.shot();
    const LcdView view = view_of(shot, screen.columns(), screen.rows());
    expect_shown(screen, cells_of(shot, view), view.top, depth);
  }

  TerminalEmulator screen;

 private:
  int master_ = -1;
  int slave_ = -1;
};

TEST(TerminalPanel, ShowsTheLcdAndLetsTheProgramPrintAboveIt) {
  for (const ColourDepth depth : {ColourDepth::True, ColourDepth::Palette256}) {
    Window window(100, 40);
    Lcd lcd;
    lcd.print("Hello");
    lcd.area(70, 150, 300, 200, {0, 0, 255}, true);
    lcd.set_menu({"GO", "", "", "END"});
    window.print("before\r\nasks: ");
    TerminalPanel panel(window.terminal(), lcd, depth);
    EXPECT_GT(panel.draw(), 0U);
    window.expect_shows(lcd, depth);
    EXPECT_EQ(window.screen.text(0), "before");
    window.print("answer");
    window.show();
    EXPECT_EQ(window.screen.text(1), "asks: answer") << "the cursor stayed where it was";

    lcd.print_at(5, 5, "changed");
    window.print("\x1b[31mred\r\n");
    panel.draw();
    for (int i = 0; i < 30; ++i) window.print("line " + std::to_string(i) + "\r\n");
    window.expect_shows(lcd, depth);
    EXPECT_EQ(window.screen.text(11), "line 29");
    EXPECT_EQ(window.screen.history().front(), "before");
    EXPECT_EQ(window.screen.history().at(1), "asks: answerred");
    EXPECT_EQ(window.screen.at(0, 11).ink, TerminalEmulator::kPalette + 1) << "still the program's";
  }
}

TEST(TerminalPanel, MakesRoomAtTheEndOfAFullWindow) {
  Window window(80, 30);
  for (int i = 0; i < 50; ++i) window.print("line " + std::to_string(i) + "\r\n");
  window.print("last");
  Lcd lcd;
  TerminalPanel panel(window.terminal(), lcd, ColourDepth::True);
  panel.draw();
  window.expect_shows(lcd);
  EXPECT_EQ(window.screen.text(2), "last");
  EXPECT_EQ(window.screen.history().back(), "line 47");
}

TEST(TerminalPanel, SendsOnlyWhatHasChanged) {
  Window window(100, 40);
  Lcd lcd;
  TerminalPanel panel(window.terminal(), lcd, ColourDepth::True);
  panel.draw();
  EXPECT_EQ(panel.draw(), 0U);
  lcd.print_at(3, 3, "12.5");
  panel.draw();
  lcd.print_at(3, 3, "12.7");
  EXPECT_LT(panel.draw(), 70U);
  lcd.print_at(3, 3, "12.7");
  EXPECT_EQ(panel.draw(), 0U) << "the same again";
  window.expect_shows(lcd);
}

TEST(TerminalPanel, FollowsTheSizeOfTheWindow) {
  Window window(100, 40);
  Lcd lcd;
  lcd.set_menu({"GO", "", "", "END"});
  lcd.print("Hello");
  TerminalPanel panel(window.terminal(), lcd, ColourDepth::True);
  panel.draw();
  for (const auto& [columns, rows] : {std::pair{60, 20}, {132, 50}, {12, 40}, {80, 3}, {80, 24}}) {
    window.resize(columns, rows);
    panel.draw();
    window.expect_shows(lcd);
    const bool is_tiny = columns < 16 || rows < 4;
    EXPECT_EQ(window.screen.has_region(), !is_tiny);
    window.print("on\r\n");
    window.expect_shows(lcd);
  }
}

TEST(TerminalPanel, FollowsTheSizeOfTheFont) {
  Window window(100, 20);
  Lcd lcd;
  lcd.print("Hello");
  TerminalPanel panel(window.terminal(), lcd, ColourDepth::True);
  panel.draw();
  for (const int size : {24, 8, 12}) {
    ASSERT_TRUE(lcd.set_font_size(size));
    lcd.print("x");
    panel.draw();
    window.expect_shows(lcd);
    const int columns = view_of(lcd.shot(), 100, 20).columns;
    for (int column = columns; column < 100; ++column) {
      ASSERT_EQ(window.screen.at(column, 12).glyph, U' ') << "nothing is left of what was wider";
    }
  }
}

TEST(TerminalPanel, KnowsThePixelUnderACharacter) {
  Window window(100, 40);
  Lcd lcd;
  TerminalPanel panel(window.terminal(), lcd, ColourDepth::True);
  EXPECT_EQ(panel.pixel_at(0, 39), std::nullopt) << "nothing is drawn yet";
  panel.draw();
  EXPECT_EQ(panel.pixel_at(10, 13 + 4), (TouchPoint{73, 67}));
  EXPECT_EQ(panel.pixel_at(10, 5), std::nullopt);
}

TEST(TerminalPanel, SurvivesItsTerminal) {
  Lcd lcd;
  auto window = std::make_unique<Window>(100, 40);
  TerminalPanel panel(window->terminal(), lcd, ColourDepth::True);
  panel.draw();
  window.reset();
  lcd.print("x");
  EXPECT_EQ(panel.draw(), 0U);
  EXPECT_EQ(panel.draw(), 0U);
}

}  // namespace
}  // namespace eyebridge::robios
