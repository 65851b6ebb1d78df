#include "panel/remote_control.hpp"

#include <QGridLayout>
#include <QPixmap>
#include <algorithm>
#include <array>

namespace eyebridge::gui {
namespace {

constexpr int kSpot = 16;  // pixels, of a button with a colour

constexpr std::array<RemoteButton, 20> kButtons = {{
    {QT_TRANSLATE_NOOP("eyebridge::gui::RemoteControl", "Power"), "POWER", 'P', "Alt+P", 0, 3,
     nullptr},
    {"1", "1", '1', "Alt+1", 1, 0, nullptr},
    {"2", "2", '2', "Alt+2", 1, 1, nullptr},
    {"3", "3", '3', "Alt+3", 1, 2, nullptr},
    {"4", "4", '4', "Alt+4", 2, 0, nullptr},
    {"5", "5", '5', "Alt+5", 2, 1, nullptr},
    {"6", "6", '6', "Alt+6", 2, 2, nullptr},
    {"7", "7", '7', "Alt+7", 3, 0, nullptr},
    {"8", "8", '8', "Alt+8", 3, 1, nullptr},
    {"9", "9", '9', "Alt+9", 3, 2, nullptr},
    {"0", "0", '0', "Alt+0", 4, 1, nullptr},
    {QT_TRANSLATE_NOOP("eyebridge::gui::RemoteControl", "Red"), "RED", 'R', "Alt+R", 1, 3,
     "#c00000"},
    {QT_TRANSLATE_NOOP("eyebridge::gui::RemoteControl", "Green"), "GREEN", 'G', "Alt+G", 2, 3,
     "#008000"},
    {QT_TRANSLATE_NOOP("eyebridge::gui::RemoteControl", "Yellow"), "YELLOW", 'Y', "Alt+Y", 3, 3,
     "#c0a000"},
    {QT_TRANSLATE_NOOP("eyebridge::gui::RemoteControl", "Blue"), "BLUE", 'B', "Alt+B", 4, 3,
     "#0040c0"},
    {"▲", "UP", 'U', "Alt+Up", 5, 1, nullptr},
    {"◀", "LEFT", 'L', "Alt+Left", 6, 0, nullptr},
    {"OK", "OK", 'O', "Alt+Return", 6, 1, nullptr},
    {"▶", "RIGHT", '>', "Alt+Right", 6, 2, nullptr},
    {"▼", "DOWN", 'D', "Alt+Down", 7, 1, nullptr},
}};

}  // namespace

std::span<const RemoteButton> remote_buttons() { return kButtons; }

RemoteControl::RemoteControl(robios::Keys& keys, QWidget* parent) : QWidget(parent), keys_(keys) {
  auto* grid = new QGridLayout(this);
  for (const RemoteButton& key : kButtons) {
    auto* button = new QPushButton(tr(key.label), this);
    button->setObjectName(QString("remote_%1").arg(key.name));
    button->setAccessibleName(QString("IRTV_%1").arg(key.name));
    button->setToolTip(tr("IRTV_%1 (code %2, keyboard: %3)")
                           .arg(key.name)
                           .arg(static_cast<int>(key.code))
                           .arg(QKeySequence(key.shortcut).toString(QKeySequence::NativeText)));
    button->setMinimumSize(36, 28);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    if (key.colour != nullptr) {
      QPixmap spot(kSpot, kSpot);
      spot.fill(QColor(key.colour));
      button->setIcon(spot);
    }
    connect(button, &QPushButton::pressed, this, [this, code = key.code] { press(code); });
    grid->addWidget(button, key.row, key.column);
    buttons_.push_back(button);
  }
}

QPushButton& RemoteControl::button(char code) {
  const auto* const key = std::ranges::find(kButtons, code, &RemoteButton::code);
  return *buttons_.at(static_cast<std::size_t>(key - kButtons.begin()));
}

}  // namespace eyebridge::gui
