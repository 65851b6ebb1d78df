#include "code/output_view.hpp"

#include <QFontDatabase>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <utility>

namespace eyebridge::gui {
namespace {

constexpr int kDelay_ms = 30;

/// What a line of the output has beside its text.
struct Found final : QTextBlockUserData {
  explicit Found(Message found) : message(std::move(found)) {}
  Message message;
};

const Message* message_of(const QTextBlock& block) {
  const auto* const found = static_cast<const Found*>(block.userData());
  return found == nullptr ? nullptr : &found->message;
}

/// Without what moves a terminal's cursor and colours its text.
QString plain(QString text) {
  static const QRegularExpression kEscapes("\x1b\\[[0-9;?]*[A-Za-z]|\x1b[^\\[]");
  text.remove(kEscapes);
  text.removeIf([](QChar c) { return c < ' ' && c != '\n' && c != '\t'; });
  return text;
}

}  // namespace

OutputView::OutputView(QWidget* parent) : QPlainTextEdit(parent) {
  setObjectName("output");
  setAccessibleName(tr("Output"));
  setReadOnly(true);
  setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  setMaximumBlockCount(kMostLines);
  setUndoRedoEnabled(false);
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  viewport()->setMouseTracking(true);
  timer_.setSingleShot(true);
  timer_.setInterval(kDelay_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { flush(); });
}

void OutputView::start_anew() {
  clear();
  setExtraSelections({});
  pending_.clear();
  left_out_ = 0;
  chosen_ = -1;
  decoder_.resetState();
}

void OutputView::add(const QByteArray& bytes) {
  pending_ += bytes;
  if (pending_.size() > kMostPending) {
    const qsizetype surplus = pending_.size() - kMostPending / 2;
    pending_.remove(0, surplus);
    left_out_ += surplus;
  }
  if (!timer_.isActive()) timer_.start();
}

void OutputView::flush() {
  timer_.stop();
  if (pending_.isEmpty()) return;
  QScrollBar& bar = *verticalScrollBar();
  const bool follows = bar.value() == bar.maximum();
  if (left_out_ > 0) insert("\n" + tr("[%1 kB left out]").arg(left_out_ / 1024) + "\n");
  left_out_ = 0;
  insert(plain(decoder_.decode(std::exchange(pending_, {}))));
  if (follows) bar.setValue(bar.maximum());
}

void OutputView::insert(const QString& text) {
  QTextBlock block = document()->lastBlock();
  // Blocks that the limit removes take their numbers with them: counted from the end.
  const int before = document()->blockCount();
  QString broken;
  qsizetype length = block.length() - 1;
  int added = 0;
  for (const QChar c : text) {
    if (c == '\n' || length >= kLongestLine) {
      broken += '\n';
      length = 0;
      ++added;
    }
    if (c == '\n') continue;
    broken += c;
    ++length;
  }
  QTextCursor cursor(document());
  cursor.movePosition(QTextCursor::End);
  cursor.insertText(broken, QTextCharFormat());
  const int removed = before + added - document()->blockCount();
  if (chosen_ >= 0) chosen_ = chosen_ >= removed ? chosen_ - removed : -1;
  block = document()->lastBlock();
  for (int i = 0; i < added && block.previous().isValid(); ++i) block = block.previous();
  for (; block.isValid() && block.next().isValid(); block = block.next()) look_at(block);
}

void OutputView::look_at(QTextBlock block) {
  const QByteArray line = block.text().toUtf8();
  std::optional<Message> message =
      find_message({line.data(), static_cast<std::size_t>(line.size())});
  if (!message) return;
  block.setUserData(new Found(*message));
  underline(block, *message);
  if (on_message) on_message(*message);
}

void OutputView::underline(const QTextBlock& block, const Message& message) {
  const QByteArray line = block.text().toUtf8();
  const auto letters = [&](std::size_t bytes) {
    return static_cast<int>(QString::fromUtf8(line.left(static_cast<qsizetype>(bytes))).size());
  };
  QTextCursor cursor(block);
  cursor.setPosition(block.position() + letters(message.begin));
  cursor.setPosition(block.position() + letters(message.end), QTextCursor::KeepAnchor);
  QTextCharFormat format;
  format.setFontUnderline(true);
  format.setForeground(palette().brush(QPalette::Link));
  cursor.mergeCharFormat(format);
}

void OutputView::stress(const QTextBlock& block) {
  QTextEdit::ExtraSelection line;
  line.cursor = QTextCursor(block);
  line.format.setBackground(palette().brush(QPalette::AlternateBase));
  line.format.setProperty(QTextFormat::FullWidthSelection, true);
  setExtraSelections({line});
}

void OutputView::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  for (QTextBlock block = document()->firstBlock(); block.isValid(); block = block.next()) {
    if (const Message* const message = message_of(block)) underline(block, *message);
  }
  if (chosen_ >= 0) stress(document()->findBlockByNumber(chosen_));
}

bool OutputView::choose(const QTextBlock& block) {
  const Message* const message = message_of(block);
  if (message == nullptr) return false;
  chosen_ = block.blockNumber();
  stress(block);
  setTextCursor(QTextCursor(block));
  if (on_chosen) on_chosen(*message);
  return true;
}

bool OutputView::choose_next(bool forward) {
  flush();
  QTextBlock block;
  if (chosen_ >= 0) {
    block = document()->findBlockByNumber(chosen_);
    block = forward ? block.next() : block.previous();
  } else {
    block = forward ? document()->firstBlock() : document()->lastBlock();
  }
  for (; block.isValid(); block = forward ? block.next() : block.previous()) {
    const Message* const message = message_of(block);
    if (message != nullptr && message->severity != Message::Severity::Note) return choose(block);
  }
  return false;
}

bool OutputView::choose_if(const std::function<bool(const Message&)>& is_wanted, bool last) {
  flush();
  QTextBlock block = last ? document()->lastBlock() : document()->firstBlock();
  for (; block.isValid(); block = last ? block.previous() : block.next()) {
    const Message* const message = message_of(block);
    if (message != nullptr && is_wanted(*message)) return choose(block);
  }
  return false;
}

void OutputView::mouseMoveEvent(QMouseEvent* event) {
  QPlainTextEdit::mouseMoveEvent(event);
  const bool is_message = message_of(cursorForPosition(event->pos()).block()) != nullptr;
  viewport()->setCursor(is_message ? Qt::PointingHandCursor : Qt::IBeamCursor);
}

void OutputView::mouseReleaseEvent(QMouseEvent* event) {
  QPlainTextEdit::mouseReleaseEvent(event);
  // Who drags wants to copy.
  if (event->button() != Qt::LeftButton || textCursor().hasSelection()) return;
  choose(cursorForPosition(event->pos()).block());
}

void OutputView::keyPressEvent(QKeyEvent* event) {
  const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enters && choose(textCursor().block())) return;
  QPlainTextEdit::keyPressEvent(event);
}

}  // namespace eyebridge::gui
