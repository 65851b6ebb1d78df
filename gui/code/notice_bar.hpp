#pragma once

#include <QCoreApplication>
#include <QLabel>
#include <QWidget>
#include <functional>
#include <vector>

class QHBoxLayout;
class QPushButton;

namespace eyebridge::gui {

/// A line above a text that tells something and offers what can be done about it. It waits: nothing
/// else is held up. A new notice takes the place of the one before.
class NoticeBar final : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(NoticeBar)
 public:
  struct Choice {
    QString text;
    std::function<void()> act;  ///< The notice goes away before.
  };

  explicit NoticeBar(QWidget* parent);

  /// Shows the sentence, the choices and a button that only closes the bar.
  void show_notice(const QString& sentence, const std::vector<Choice>& choices);
  void dismiss();
  [[nodiscard]] QString sentence() const;

 private:
  QPushButton* add_button(const QString& text, const std::function<void()>& act);

  QLabel* label_;
  QHBoxLayout* row_;
  std::vector<QPushButton*> buttons_;
};

}  // namespace eyebridge::gui
