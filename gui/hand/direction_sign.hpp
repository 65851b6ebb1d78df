#pragma once

#include <QWidget>

#include "hand/hand_words.hpp"

class QPainter;

namespace eyebridge::gui {

/// An arrow and two lines of words, as big as there is room: to be read from two metres.
class DirectionSign final : public QWidget {
  Q_OBJECT

 public:
  explicit DirectionSign(QWidget* parent);

  void show_words(const HandWords& words);
  [[nodiscard]] const HandWords& words() const { return words_; }
  /// Of the headline, pixels.
  [[nodiscard]] int letter_height() const;

  [[nodiscard]] QSize sizeHint() const override { return {480, 520}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 300}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QRect headline_place() const;
  [[nodiscard]] QFont fitted(const QString& text, const QRect& place) const;

  HandWords words_;
};

/// The arrow alone, in a square of edge 2 about (0, 0), up being straight ahead.
void paint_arrow(QPainter& painter, camera::Arrow arrow);

}  // namespace eyebridge::gui
