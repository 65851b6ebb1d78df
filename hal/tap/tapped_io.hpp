#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tap/tapped_devices.hpp"

namespace eyebridge::hal {

/// Text and bytes as numbers, and back; whoever wrote the numbers, they become bytes.
template <class Bytes>
Values pack_bytes(const Bytes& bytes) {
  Values values;
  for (const auto byte : bytes) values.push_back(static_cast<unsigned char>(byte));
  return values;
}
/// Its sender, then its text; nothing when there is none.
inline Values pack_message(const std::optional<RadioMessage>& message) {
  if (!message) return {};
  Values values = pack_bytes(message->text);
  values.insert(values.begin(), static_cast<double>(message->sender));
  return values;
}
inline char to_byte(double value) {
  if (!(value > 0.0)) return 0;  // nor a number
  return static_cast<char>(static_cast<unsigned char>(std::min(value, 255.0)));
}
inline std::string unpack_text(std::span<const double> values) {
  std::string text(values.size(), '\0');
  std::transform(values.begin(), values.end(), text.begin(), to_byte);
  return text;
}

template <>
struct AsValues<std::uint16_t> {
  static constexpr std::size_t kSize = 1;
  static Values pack(std::uint16_t value) { return {static_cast<double>(value)}; }
  static std::uint16_t unpack(const Values& v) {
    return static_cast<std::uint16_t>(std::clamp(v[0], 0.0, 65535.0));
  }
};

/// A device whose calls name a line, a channel: that is the number that scripts and recordings see.
template <class Device>
class TappedLines : public Tapped<Device> {
 public:
  using Tapped<Device>::Tapped;

 protected:
  template <class Value, class Ask>
  Result<Value> reading_of(int number, std::string_view name, const Ask& ask) {
    const Call call{this->kind_, number, name, false, {}};
    return reply_as<Value>(call, this->tap_.exchange(call, [&]() -> Result<Values> {
      return ask().map(AsValues<Value>::pack);
    }));
  }
  template <class CarryOut>
  Result<void> command_to(int number, std::string_view name, Values request,
                          const CarryOut& carry_out) {
    const Call call{this->kind_, number, name, true, std::move(request)};
    return this->tap_
        .exchange(call,
                  [&]() -> Result<Values> { return carry_out().map([] { return Values{}; }); })
        .map([](const Values&) {});
  }
};

class TappedDigitalLines final : public TappedLines<DigitalLines> {
 public:
  using TappedLines::TappedLines;
  Result<void> setup(int line, LineMode mode) override {
    return command_to(line, "setup", {static_cast<double>(mode)},
                      [&] { return inner_.setup(line, mode); });
  }
  Result<bool> read(int line) override {
    return reading_of<bool>(line, "read", [&] { return inner_.read(line); });
  }
  Result<std::uint16_t> read_all() override { return reading("read_all", &DigitalLines::read_all); }
  Result<void> write(int line, bool high) override {
    return command_to(line, "write", {high ? 1.0 : 0.0}, [&] { return inner_.write(line, high); });
  }
};

class TappedAnalogInputs final : public TappedLines<AnalogInputs> {
 public:
  using TappedLines::TappedLines;
  Result<int> read(int channel) override {
    return reading_of<int>(channel, "read", [&] { return inner_.read(channel); });
  }
  Result<double> supply_voltage() override {
    return reading_of<double>(kSupply, "supply_voltage", [&] { return inner_.supply_voltage(); });
  }
};

/// A device that hands over what has come, each once: nothing comes while a tap keeps it.
template <class Device>
class TappedInbox : public Tapped<Device> {
 public:
  using Tapped<Device>::Tapped;

 protected:
  template <class Take>
  Result<Values> taking(std::string_view name, Values request, const Take& take) {
    // As a command: nobody may be given twice what came once.
    return this->tap_.exchange({this->kind_, this->id_, name, true, std::move(request)}, take);
  }
};

class TappedRemote final : public TappedInbox<Remote> {
 public:
  using TappedInbox::TappedInbox;
  Result<int> read() override {
    return taking("read", {}, [&] { return inner_.read().map(AsValues<int>::pack); })
        .map([](const Values& code) {
          return code.empty() ? 0 : static_cast<unsigned char>(to_byte(code[0]));
        });
  }
};

class TappedIoBoard final : public Tapped<IoBoard> {
 public:
  using Tapped::Tapped;
  Result<std::string> version() override {
    const Call call{kind_, id_, "version", false, {}};
    return tap_.exchange(call, [&] { return inner_.version().map(pack_bytes<std::string>); })
        .map([](const Values& values) { return unpack_text(values); });
  }
};

class TappedSerialPort final : public TappedInbox<SerialPort> {
 public:
  using TappedInbox::TappedInbox;
  Result<void> open(int baud, bool handshake) override {
    return command("open", {static_cast<double>(baud), handshake ? 1.0 : 0.0},
                   [&] { return inner_.open(baud, handshake); });
  }
  Result<void> send(std::span<const std::uint8_t> bytes) override {
    return command("send", pack_bytes(bytes), [&] { return inner_.send(bytes); });
  }
  Result<std::size_t> receive(std::span<std::uint8_t> buffer, Time patience) override {
    const Values request{static_cast<double>(buffer.size()), to_seconds(patience)};
    const Result<Values> came = taking("receive", request, [&]() -> Result<Values> {
      return inner_.receive(buffer, patience).map([&](std::size_t count) {
        return pack_bytes(buffer.first(count));
      });
    });
    if (!came) return tl::unexpected(came.error());
    if (came->size() > buffer.size()) {
      return fail(Errc::Corrupt,
                  fmt::format("serial {}: {} bytes in the reply, expected at most {}", id_,
                              came->size(), buffer.size()));
    }
    std::transform(came->begin(), came->end(), buffer.begin(),
                   [](double value) { return static_cast<std::uint8_t>(to_byte(value)); });
    return came->size();
  }
  Result<std::size_t> pending() override {
    const Call call{kind_, id_, "pending", false, {}};
    return reply_as<int>(call, tap_.exchange(call,
                                             [&] {
                                               return inner_.pending().map([](std::size_t count) {
                                                 return Values{static_cast<double>(count)};
                                               });
                                             }))
        .map([](int count) { return static_cast<std::size_t>(std::max(count, 0)); });
  }
  Result<void> flush() override {
    return command("flush", {}, [&] { return inner_.flush(); });
  }
  Result<void> close() override {
    return command("close", {}, [&] { return inner_.close(); });
  }
};

class TappedSound final : public Tapped<Sound> {
 public:
  using Tapped::Tapped;
  Result<void> tone(double frequency, double duration) override {
    return command("tone", {frequency, duration}, [&] { return inner_.tone(frequency, duration); });
  }
  Result<void> play(const std::string& path) override {
    return command("play", pack_bytes(path), [&] { return inner_.play(path); });
  }
  Result<bool> is_playing() override { return reading("is_playing", &Sound::is_playing); }
};

class TappedRadio final : public TappedInbox<Radio> {
 public:
  using TappedInbox::TappedInbox;
  [[nodiscard]] int id() const override { return inner_.id(); }
  Result<void> start() override {
    return command("start", {}, [&] { return inner_.start(); });
  }
  Result<void> stop() override {
    return command("stop", {}, [&] { return inner_.stop(); });
  }
  Result<void> send(int receiver, const std::string& text) override {
    Values request = pack_bytes(text);
    request.insert(request.begin(), static_cast<double>(receiver));
    return command("send", std::move(request), [&] { return inner_.send(receiver, text); });
  }
  Result<std::optional<RadioMessage>> receive() override {
    return taking("receive", {}, [&] { return inner_.receive().map(pack_message); })
        .map([](const Values& values) -> std::optional<RadioMessage> {
          if (values.empty()) return std::nullopt;
          RadioMessage message;
          message.sender = static_cast<unsigned char>(to_byte(values[0]));
          message.text = unpack_text(std::span(values).subspan(1));
          return message;
        });
  }
  Result<std::vector<int>> robots() override {
    const Call call{kind_, id_, "robots", false, {}};
    return tap_
        .exchange(call,
                  [&] {
                    return inner_.robots().map(
                        [](const std::vector<int>& ids) { return Values(ids.begin(), ids.end()); });
                  })
        .map([](const Values& values) {
          std::vector<int> ids;
          for (const double id : values) ids.push_back(static_cast<unsigned char>(to_byte(id)));
          return ids;
        });
  }
};

}  // namespace eyebridge::hal
