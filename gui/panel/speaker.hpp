#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <atomic>
#include <memory>
#include <optional>

#include "eyebridge/hal/device_notes.hpp"
#include "panel/stamp_times.hpp"
#include "widgets/worker.hpp"

namespace eyebridge::gui {

/// Lights while the robot's loudspeaker plays, and says what: the tone, or the file; the last one
/// stays to be read.
class Speaker final : public QWidget {
  Q_OBJECT

 public:
  /// `notes` is lent.
  Speaker(const hal::DeviceNotes& notes, QWidget* parent);

  /// Looks whether something plays now.
  void refresh();
  /// The program has ended, and its clock does not go on.
  void put_out();
  [[nodiscard]] bool is_lit() const { return is_lit_; }
  [[nodiscard]] const QString& text() const { return text_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {40, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void take(const hal::SoundNote& sound);
  void read_length(const hal::SoundNote& sound);
  void show_length(std::uint64_t sound, std::optional<double> length);

  const hal::DeviceNotes& notes_;
  StampTimes times_;
  std::uint64_t heard_ = 0;  ///< Sounds so far.
  Time begin_{0};            ///< Of the last one, on the program's clock …
  Time end_{0};              ///< … which is not known while its file is being read.
  bool is_read_ = true;
  QElapsedTimer since_;  ///< It began.
  bool is_lit_ = false;
  QString text_;
  std::atomic<std::uint64_t> newest_ = 0;  ///< heard_, for the reader: older ones wait in vain.
  std::unique_ptr<Worker> reader_;  ///< Of sound files; where none was played, there is none.
};

}  // namespace eyebridge::gui
