#include "monkey.hpp"

#include <QAction>
#include <QApplication>
#include <QDrag>
#include <QMenu>
#include <QMouseEvent>
#include <QPointer>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <utility>

namespace eyebridge::gui::testing {
namespace {

constexpr std::array kKeysBesideLetters = {
    Qt::Key_Escape,    Qt::Key_Return,     Qt::Key_Tab,      Qt::Key_Backtab,    Qt::Key_Backspace,
    Qt::Key_Delete,    Qt::Key_Up,         Qt::Key_Down,     Qt::Key_Left,       Qt::Key_Right,
    Qt::Key_Home,      Qt::Key_End,        Qt::Key_PageUp,   Qt::Key_PageDown,   Qt::Key_Space,
    Qt::Key_Period,    Qt::Key_Comma,      Qt::Key_Minus,    Qt::Key_Plus,       Qt::Key_ParenLeft,
    Qt::Key_BraceLeft, Qt::Key_BraceRight, Qt::Key_QuoteDbl, Qt::Key_NumberSign, Qt::Key_F1,
    Qt::Key_F3,        Qt::Key_F5,         Qt::Key_F6,       Qt::Key_F7};

}  // namespace

Monkey::Monkey(std::vector<QWidget*> windows, unsigned seed)
    : windows_(std::move(windows)), random_(seed) {}

int Monkey::below(int bound) {
  return std::uniform_int_distribution<int>(0, std::max(1, bound) - 1)(random_);
}

void Monkey::let_go() {
  if (!acts_) return;
  QDrag::cancel();
  if (QWidget* const popup = QApplication::activePopupWidget()) popup->close();
  close_dialog();
}

void Monkey::act() {
  acts_ = true;
  act_now();
  acts_ = false;
}

void Monkey::act_now() {
  QWidget& widget = any_widget();
  const QPoint place(below(widget.width()), below(widget.height()));
  constexpr std::array kButtons = {Qt::LeftButton, Qt::LeftButton, Qt::RightButton,
                                   Qt::MiddleButton};
  const Qt::MouseButton button = kButtons.at(static_cast<std::size_t>(below(4)));
  const Qt::KeyboardModifiers keys = any_modifiers();
  switch (below(10)) {
    case 0:
      QTest::mouseDClick(&widget, button, keys, place);
      break;
    case 1:
    case 2:
      drag(widget, button, keys, place);
      break;
    case 3:
      turn_wheel(widget, keys, place);
      break;
    case 4:
    case 5:
    case 6:
      QTest::keyClick(&widget, any_key(), keys);
      break;
    case 7:
      choose_from_menu();
      break;
    default:
      QTest::mouseClick(&widget, button, keys, place);
  }
}

QWidget& Monkey::any_widget() {
  if (QWidget* const popup = QApplication::activePopupWidget()) return *popup;
  // What has the keyboard gets more of it than chance would give.
  QWidget* const focus = QApplication::focusWidget();
  if (focus != nullptr && windows_.end() != std::ranges::find(windows_, focus->window()) &&
      below(4) == 0) {
    return *focus;
  }
  QWidget* const window =
      windows_.at(static_cast<std::size_t>(below(static_cast<int>(windows_.size()))));
  if (below(8) == 0) window->activateWindow();
  QList<QWidget*> shown{window};
  for (QWidget* child : window->findChildren<QWidget*>()) {
    // Dialogs are closed: somebody who types into one for files may remove any that there is.
    const bool is_ours = child->window() == window || child->window()->inherits("QDockWidget");
    if (is_ours && child->isVisible() && child->isEnabled()) shown.push_back(child);
  }
  return *shown.at(below(static_cast<int>(shown.size())));
}

Qt::KeyboardModifiers Monkey::any_modifiers() {
  constexpr std::array kModifiers = {Qt::NoModifier,    Qt::NoModifier,      Qt::NoModifier,
                                     Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier};
  return kModifiers.at(static_cast<std::size_t>(below(6)));
}

Qt::Key Monkey::any_key() {
  if (below(2) == 0) {
    return kKeysBesideLetters.at(
        static_cast<std::size_t>(below(static_cast<int>(kKeysBesideLetters.size()))));
  }
  return static_cast<Qt::Key>(Qt::Key_0 + below(Qt::Key_Z - Qt::Key_0 + 1));
}

void Monkey::drag(QWidget& widget, Qt::MouseButton button, Qt::KeyboardModifiers keys,
                  QPoint place) {
  const QPointer<QWidget> alive(&widget);
  QTest::mousePress(&widget, button, keys, place);
  for (int i = 0; i < 4 && alive; ++i) {
    const QPoint to = place + QPoint(below(160) - 80, below(160) - 80);
    QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, button, keys);
    QApplication::sendEvent(&widget, &move);
  }
  if (alive) QTest::mouseRelease(&widget, button, keys, place);
}

void Monkey::turn_wheel(QWidget& widget, Qt::KeyboardModifiers keys, QPoint place) {
  QWheelEvent wheel(place, widget.mapToGlobal(QPointF(place)), {}, {0, 120 * (below(7) - 3)},
                    Qt::NoButton, keys, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &wheel);
}

void Monkey::choose_from_menu() {
  QWidget* const window =
      windows_.at(static_cast<std::size_t>(below(static_cast<int>(windows_.size()))));
  QList<QAction*> entries;
  for (QAction* const action : window->findChildren<QAction*>()) {
    if (action->menu() == nullptr && action->isEnabled()) entries.push_back(action);
  }
  if (!entries.isEmpty()) entries.at(below(static_cast<int>(entries.size())))->trigger();
}

void Monkey::close_dialog() {
  QWidget* const dialog = QApplication::activeModalWidget();
  if (dialog == nullptr) return;
  dialog->close();
}

}  // namespace eyebridge::gui::testing
