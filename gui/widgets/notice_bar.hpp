#pragma once

#include <QString>
#include <QWidget>
#include <functional>
#include <map>
#include <vector>

namespace eyebridge::gui {

/// What a person should know or decide, above the plan: nobody has to answer at once.
class NoticeBar final : public QWidget {
 public:
  struct Answer {
    QString text;
    std::function<void()> act;
  };

  explicit NoticeBar(QWidget* parent);

  /// A line with a button for each answer, instead of any about the same topic. An answer ends it;
  /// without answers there is a button that only does that.
  void tell(const QString& topic, const QString& text, const std::vector<Answer>& answers = {});
  void end(const QString& topic);
  /// What is said about a topic; empty when nothing is.
  [[nodiscard]] QString text(const QString& topic) const;

 private:
  std::map<QString, QWidget*> lines_;
};

}  // namespace eyebridge::gui
