#pragma once

#include <QAction>
#include <QSettings>
#include <QTest>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "environment/environment_window.hpp"
#include "room.hpp"

namespace eyebridge::gui::testing {

/// An environment's window on a room, as big as a person would have it, and her hands.
class EnvironmentFixture : public ::testing::Test {
 protected:
  void SetUp() override {
    QSettings().clear();  // as the first window of all
    window_.emplace(room_.environment(), "square", &crew_);
    window_->resize(1000, 900);
    window_->show();
    window_->activateWindow();  // shortcuts are those of the active window
    ASSERT_TRUE(QTest::qWaitForWindowActive(&*window_));
    window_->view().fit();
    window_->view().refresh();
  }
  QPoint at(double x, double y) { return window_->view().viewport().to_pixel({x, y}).toPoint(); }
  void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton) {
    WorldView& view = window_->view();
    QTest::mousePress(&view, button, {}, from);
    for (int i = 1; i <= 10; ++i) {
      const QPoint place = from + (to - from) * i / 10.0;
      QMouseEvent move(QEvent::MouseMove, place, view.mapToGlobal(place), Qt::NoButton, button, {});
      QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, button, {}, to);
  }
  QAction& action(const QString& text) {
    for (QAction* action : window_->findChildren<QAction*>()) {
      if (action->text().remove('&') == text) return *action;
    }
    throw std::runtime_error("no action " + text.toStdString());
  }
  /// Whether anything is drawn on the floor there, give or take a pixel or two up and down.
  bool is_drawn_at(double x, double y) {
    const QImage picture = window_->view().grab().toImage();
    const QColor floor = picture.pixelColor(at(0.6, 0.9));
    for (int dy = -2; dy <= 2; ++dy) {
      if (picture.pixelColor(at(x, y) + QPoint(0, dy)) != floor) return true;
    }
    return false;
  }

  /// Keeps what it was asked for, and lets nobody in or out.
  struct AskedCrew final : robios::Crew {
    Result<std::size_t> add(const std::vector<std::string>& asked) override {
      const std::lock_guard lock(mutex);
      words = asked;
      return fail(Errc::OutOfRange, "the run has ended");
    }
    Result<void> remove(std::size_t index) override {
      const std::lock_guard lock(mutex);
      removed.push_back(index);
      return {};
    }
    std::mutex mutex;
    std::vector<std::string> words;
    std::vector<std::size_t> removed;
  };

  AskedCrew crew_;
  Room room_;
  std::optional<EnvironmentWindow> window_;
};

}  // namespace eyebridge::gui::testing
