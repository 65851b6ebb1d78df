#include "widgets/notice_bar.hpp"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace eyebridge::gui {
namespace {

class NoticeText {
  Q_DECLARE_TR_FUNCTIONS(NoticeBar)
};

}  // namespace

NoticeBar::NoticeBar(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(1);
  hide();
}

void NoticeBar::tell(const QString& topic, const QString& text,
                     const std::vector<Answer>& answers) {
  end(topic);
  auto* line = new QWidget(this);
  line->setAutoFillBackground(true);
  line->setBackgroundRole(QPalette::ToolTipBase);
  auto* row = new QHBoxLayout(line);
  auto* label = new QLabel(text, line);
  label->setObjectName("notice");
  label->setForegroundRole(QPalette::ToolTipText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addWidget(label, 1);
  const auto add = [&](const QString& word, const std::function<void()>& act) {
    auto* button = new QPushButton(word, line);
    connect(button, &QPushButton::clicked, this, [this, topic, act] {
      end(topic);
      if (act) act();
    });
    row->addWidget(button);
  };
  for (const Answer& answer : answers) add(answer.text, answer.act);
  if (answers.empty()) add(NoticeText::tr("Close"), {});
  layout()->addWidget(line);
  lines_[topic] = line;
  show();
}

void NoticeBar::end(const QString& topic) {
  const auto found = lines_.find(topic);
  if (found == lines_.end()) return;
  // A button of it may be what asks.
  found->second->hide();
  found->second->deleteLater();
  lines_.erase(found);
  if (lines_.empty()) hide();
}

QString NoticeBar::text(const QString& topic) const {
  const auto found = lines_.find(topic);
  return found == lines_.end() ? QString() : found->second->findChild<QLabel*>("notice")->text();
}

}  // namespace eyebridge::gui
