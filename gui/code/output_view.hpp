#pragma once

#include <QCoreApplication>
#include <QPlainTextEdit>
#include <QStringDecoder>
#include <QTimer>
#include <functional>

#include "code/messages.hpp"

namespace eyebridge::gui {

/// What a build and a run print. Lines that name a place in a file are underlined; a click or Enter
/// chooses them.
class OutputView final : public QPlainTextEdit {
  Q_DECLARE_TR_FUNCTIONS(OutputView)
 public:
  /// How many lines are kept, and how much that has not been shown yet, bytes: more is left out.
  static constexpr int kMostLines = 10'000;
  static constexpr qsizetype kMostPending = 512 * 1024;
  /// Where a line is broken that has no end, letters.
  static constexpr int kLongestLine = 2000;

  explicit OutputView(QWidget* parent);

  void start_anew();
  /// Shows bytes of UTF-8, cut anywhere, a little later: many programs print more than a person
  /// sees.
  void add(const QByteArray& bytes);
  /// Shows what waits, at once.
  void flush();
  /// Chooses the next message, or the one before, that is no note; false when there is none.
  bool choose_next(bool forward);
  /// Chooses the first message, or the last, that `is_wanted`.
  bool choose_if(const std::function<bool(const Message&)>& is_wanted, bool last);

  /// Called for each message that came, and for the one that was chosen.
  std::function<void(const Message&)> on_message;
  std::function<void(const Message&)> on_chosen;

 protected:
  void changeEvent(QEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void insert(const QString& text);
  void look_at(QTextBlock block);
  bool choose(const QTextBlock& block);
  void underline(const QTextBlock& block, const Message& message);
  void stress(const QTextBlock& block);

  QByteArray pending_;
  qsizetype left_out_ = 0;
  QStringDecoder decoder_{QStringDecoder::Utf8};
  QTimer timer_;
  int chosen_ = -1;  ///< Number of the block; -1: none yet.
};

}  // namespace eyebridge::gui
