// Somebody who clicks and types at random, in all windows at once: nothing crashes, nothing leaks
// (ASan). EYEBRIDGE_TEST_MONKEY_ACTS: how often; EYEBRIDGE_TEST_MONKEY_SEED: another somebody.
#include <QDir>
#include <QMouseEvent>
#include <QPointer>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "editor/editor_window.hpp"
#include "environment/environment_window.hpp"
#include "eyebridge/base/jumping_clock.hpp"
#include "keys.hpp"
#include "lcd.hpp"
#include "panel/panel_window.hpp"
#include "room.hpp"

namespace eyebridge::gui {
namespace {

int number_of(const char* variable, int otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

class Monkey {
 public:
  Monkey(std::vector<QWidget*> windows, unsigned seed)
      : windows_(std::move(windows)), random_(seed) {}

  void act() {
    QWidget& widget = any_widget();
    const QPoint place(below(widget.width()), below(widget.height()));
    constexpr std::array kButtons = {Qt::LeftButton, Qt::LeftButton, Qt::RightButton,
                                     Qt::MiddleButton};
    const Qt::MouseButton button = kButtons.at(static_cast<std::size_t>(below(4)));
    const Qt::KeyboardModifiers keys = any_modifiers();
    switch (below(8)) {
      case 0:
        QTest::mouseDClick(&widget, button, keys, place);
        break;
      case 1:
      case 2:
        drag(widget, button, keys, place);
        break;
      case 3: {
        QWheelEvent wheel(place, widget.mapToGlobal(QPointF(place)), {}, {0, 120 * (below(7) - 3)},
                          Qt::NoButton, keys, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&widget, &wheel);
        break;
      }
      case 4:
      case 5:
        QTest::keyClick(&widget, any_key(), keys);
        break;
      default:
        QTest::mouseClick(&widget, button, keys, place);
    }
  }

  int below(int bound) {
    return std::uniform_int_distribution<int>(0, std::max(1, bound) - 1)(random_);
  }

 private:
  QWidget& any_widget() {
    if (QWidget* const popup = QApplication::activePopupWidget()) return *popup;
    QWidget* const window =
        windows_.at(static_cast<std::size_t>(below(static_cast<int>(windows_.size()))));
    QList<QWidget*> shown{window};
    for (QWidget* child : window->findChildren<QWidget*>()) {
      if (child->isVisible() && child->isEnabled()) shown.push_back(child);
    }
    return *shown.at(below(static_cast<int>(shown.size())));
  }
  Qt::KeyboardModifiers any_modifiers() {
    constexpr std::array kModifiers = {Qt::NoModifier,    Qt::NoModifier,      Qt::NoModifier,
                                       Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier};
    return kModifiers.at(static_cast<std::size_t>(below(6)));
  }
  Qt::Key any_key() {
    constexpr std::array kOthers = {Qt::Key_Escape, Qt::Key_Return, Qt::Key_Tab,   Qt::Key_Delete,
                                    Qt::Key_Up,     Qt::Key_Down,   Qt::Key_Left,  Qt::Key_Right,
                                    Qt::Key_Space,  Qt::Key_Period, Qt::Key_Minus, Qt::Key_F5};
    if (below(2) == 0)
      return kOthers.at(static_cast<std::size_t>(below(static_cast<int>(kOthers.size()))));
    return static_cast<Qt::Key>(Qt::Key_0 + below(Qt::Key_Z - Qt::Key_0 + 1));
  }
  void drag(QWidget& widget, Qt::MouseButton button, Qt::KeyboardModifiers keys, QPoint place) {
    const QPointer<QWidget> alive(&widget);
    QTest::mousePress(&widget, button, keys, place);
    for (int i = 0; i < 4 && alive; ++i) {
      const QPoint to = place + QPoint(below(160) - 80, below(160) - 80);
      QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, button, keys);
      QApplication::sendEvent(&widget, &move);
    }
    if (alive) QTest::mouseRelease(&widget, button, keys, place);
  }

  const std::vector<QWidget*> windows_;
  std::mt19937 random_;
};

TEST(AMonkey, BreaksNothing) {
  const eyebridge::testing::ScratchFolder home;
  qputenv("XDG_DATA_HOME", QByteArray::fromStdString(home.path()));
  const QString before = QDir::currentPath();
  QDir::setCurrent(QString::fromStdString(home.path()));  // what it saves
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  testing::Room room;
  EnvironmentWindow environment(room.environment(), "monkey");
  robios::Lcd lcd;
  JumpingClock clock;
  robios::Keys keys(clock, {}, nullptr);
  PanelWindow panel(robios::PanelStart{"monkey – robot", &lcd, &keys});
  EditorWindow editor("");
  const std::vector<QWidget*> windows = {&environment, &panel, &editor};
  for (QWidget* window : windows) window->show();
  // Whatever dialog it opens, somebody closes.
  QTimer closer;
  QObject::connect(&closer, &QTimer::timeout, [] {
    if (QWidget* const dialog = QApplication::activeModalWidget()) dialog->close();
  });
  closer.start(5);
  const int seed = number_of("EYEBRIDGE_TEST_MONKEY_SEED", 1);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Monkey monkey(windows, static_cast<unsigned>(seed));
  const int acts = number_of("EYEBRIDGE_TEST_MONKEY_ACTS", 600);
  for (int i = 0; i < acts; ++i) {
    monkey.act();
    QApplication::processEvents();
    for (QWidget* window : windows) window->show();  // it closes them, too
    if (i % 10 != 0) continue;
    if (room.environment().time().is_paused()) {
      room.environment().time().resume();
    }
    EXPECT_TRUE(room.environment().time().set_factor(hal::TimeControl::kFastest));
    room.pass(0.05);
  }
  QDir::setCurrent(before);
  // Robots are still in the world that they were in.
  hal::WorldLook look;
  room.environment().look(look);
  EXPECT_EQ(look.robots.size(), 2U);
}

}  // namespace
}  // namespace eyebridge::gui
