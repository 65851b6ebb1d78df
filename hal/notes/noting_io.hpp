#pragma once

#include <array>
#include <string>
#include <utility>

#include "notes/noting_devices.hpp"

namespace eyebridge::hal {

class NotingDigitalLines final : public Noting<DigitalLines> {
 public:
  NotingDigitalLines(DigitalLines& inner, DeviceNotes& notes) : Noting(inner, notes) {
    for (int line = 1; line <= kCount; ++line) {
      const auto i = static_cast<std::size_t>(line - 1);
      read_[i] = &notes.add("digital", line, "", Quantity::Level);
      written_[i] = &notes.add("digital", line, "", Quantity::WrittenLevel);
    }
    all_ = &notes.add("digital", 0, "", Quantity::Lines);
  }

  Result<void> setup(int line, LineMode mode) override { return inner_.setup(line, mode); }
  Result<bool> read(int line) override {
    Result<bool> level = inner_.read(line);
    return is_line(line) ? noted(*read_[index_of(line)], std::move(level)) : level;
  }
  Result<std::uint16_t> read_all() override {
    return noted(*all_, inner_.read_all(),
                 [](std::uint16_t bits) { return NoteCell::Values{static_cast<double>(bits)}; });
  }
  Result<void> write(int line, bool high) override {
    Result<void> done = inner_.write(line, high);
    if (!is_line(line)) return done;
    return noted(*written_[index_of(line)], std::move(done), {high ? 1.0 : 0.0});
  }

 private:
  static bool is_line(int line) { return line >= 1 && line <= kCount; }
  static std::size_t index_of(int line) { return static_cast<std::size_t>(line - 1); }

  std::array<NoteCell*, kCount> read_{};
  std::array<NoteCell*, kCount> written_{};
  NoteCell* all_ = nullptr;
};

class NotingAnalogInputs final : public Noting<AnalogInputs> {
 public:
  NotingAnalogInputs(AnalogInputs& inner, DeviceNotes& notes)
      : Noting(inner, notes), voltage_(notes.add("analog", kSupply, "", Quantity::Voltage)) {
    for (int channel = 0; channel <= kLast; ++channel) {
      counts_[static_cast<std::size_t>(channel)] =
          &notes.add("analog", channel, "", Quantity::Count);
    }
  }

  Result<int> read(int channel) override {
    Result<int> count = inner_.read(channel);
    if (channel < 0 || channel > kLast) return count;
    return noted(*counts_[static_cast<std::size_t>(channel)], std::move(count));
  }
  Result<double> supply_voltage() override { return noted(voltage_, inner_.supply_voltage()); }

 private:
  NoteCell& voltage_;
  std::array<NoteCell*, kLast + 1> counts_{};
};

/// Notes the codes that came, not that none did.
class NotingRemote final : public Noting<Remote> {
 public:
  NotingRemote(Remote& inner, DeviceNotes& notes)
      : Noting(inner, notes), code_(notes.add("remote", 1, "", Quantity::RemoteCode)) {}

  Result<int> read() override {
    Result<int> code = inner_.read();
    return code && *code == 0 ? code : noted(code_, std::move(code));
  }

 private:
  NoteCell& code_;
};

/// Notes the sounds that could be played.
class NotingSound final : public Sound {
 public:
  NotingSound(Sound& inner, DeviceNotes& notes) : inner_(inner), notes_(notes) {}

  Result<void> tone(double frequency, double duration) override {
    return inner_.tone(frequency, duration).map([&] {
      SoundNote note;
      note.frequency = frequency;
      note.length = duration;
      notes_.put_sound(std::move(note));
    });
  }
  Result<void> play(const std::string& path) override {
    return inner_.play(path).map([&] {
      SoundNote note;
      note.file = path;
      notes_.put_sound(std::move(note));
    });
  }
  Result<bool> is_playing() override { return inner_.is_playing(); }

 private:
  Sound& inner_;
  DeviceNotes& notes_;
};

}  // namespace eyebridge::hal
