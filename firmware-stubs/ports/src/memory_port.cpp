#include <array>
#include <utility>

#include "eyebridge/ports/port.hpp"

namespace eyebridge::ports {
namespace {

class MemoryBytes : public Port {
 public:
  MemoryBytes(ByteLine line, ByteFunctions functions)
      : line_(std::move(line)), functions_(std::move(functions)) {}

  void pump() override {
    std::array<std::uint8_t, 512> buffer;
    while (connected_) {
      const std::ptrdiff_t got = functions_.read(buffer);
      if (got < 0) {
        connected_ = false;
        line_.lost();
        return;
      }
      if (got > 0) line_.receive(std::span(buffer).first(static_cast<std::size_t>(got)));
      bool said = false;
      for (std::size_t made = 0; (made = line_.transmit(buffer)) > 0; said = true) {
        functions_.write(std::span(buffer).first(made));
      }
      if (got == 0 && !said) return;
    }
  }
  [[nodiscard]] int descriptor() const override { return -1; }
  [[nodiscard]] bool connected() const override { return connected_; }
  [[nodiscard]] std::string address() const override { return "memory"; }

 private:
  ByteLine line_;
  ByteFunctions functions_;
  bool connected_ = true;
};

class MemoryFrames : public Port {
 public:
  MemoryFrames(FrameLine line, FrameFunctions functions)
      : line_(std::move(line)), functions_(std::move(functions)) {}

  void pump() override {
    eb_can_frame frame{};
    for (int got = 1; connected_ && got != 0;) {
      got = functions_.read(frame);
      if (got < 0) {
        connected_ = false;
        line_.lost();
        return;
      }
      if (got > 0) line_.receive(frame);
    }
    while (connected_ && line_.transmit(frame)) functions_.write(frame);
  }
  [[nodiscard]] int descriptor() const override { return -1; }
  [[nodiscard]] bool connected() const override { return connected_; }
  [[nodiscard]] std::string address() const override { return "memory"; }

 private:
  FrameLine line_;
  FrameFunctions functions_;
  bool connected_ = true;
};

}  // namespace

std::unique_ptr<Port> make_memory_port(ByteLine line, ByteFunctions functions) {
  return std::make_unique<MemoryBytes>(std::move(line), std::move(functions));
}

std::unique_ptr<Port> make_memory_port(FrameLine line, FrameFunctions functions) {
  return std::make_unique<MemoryFrames>(std::move(line), std::move(functions));
}

}  // namespace eyebridge::ports
