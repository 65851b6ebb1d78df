#include "code/notice_bar.hpp"

#include <QHBoxLayout>
#include <QPushButton>

namespace eyebridge::gui {

NoticeBar::NoticeBar(QWidget* parent)
    : QWidget(parent), label_(new QLabel(this)), row_(new QHBoxLayout(this)) {
  setObjectName("notice");
  setAccessibleName(tr("Notice"));
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::ToolTipBase);
  setForegroundRole(QPalette::ToolTipText);
  label_->setForegroundRole(QPalette::ToolTipText);
  label_->setTextFormat(Qt::PlainText);
  label_->setWordWrap(true);
  row_->setContentsMargins(8, 4, 8, 4);
  row_->addWidget(label_, 1);
  hide();
}

QPushButton* NoticeBar::add_button(const QString& text, const std::function<void()>& act) {
  auto* const button = new QPushButton(text, this);
  connect(button, &QPushButton::clicked, this, [this, act] {
    dismiss();
    if (act) act();
  });
  row_->addWidget(button);
  buttons_.push_back(button);
  return button;
}

void NoticeBar::show_notice(const QString& sentence, const std::vector<Choice>& choices) {
  dismiss();
  label_->setText(sentence);
  for (const Choice& choice : choices) add_button(choice.text, choice.act);
  add_button(tr("Close"), {});
  show();
}

void NoticeBar::dismiss() {
  hide();
  // One of them may be the one that is being clicked.
  for (QPushButton* const button : buttons_) button->deleteLater();
  for (QPushButton* const button : buttons_) button->hide();
  buttons_.clear();
  label_->clear();
}

QString NoticeBar::sentence() const { return label_->text(); }

}  // namespace eyebridge::gui
