#include "hand/display.hpp"

#include <cstdio>
#include <stdexcept>
#include <utility>

#include <unistd.h>

#include "eyebridge/camera/png.hpp"

namespace eyebridge::hal {
namespace {

namespace fs = std::filesystem;

constexpr Time kPeriod = std::chrono::milliseconds(200);

// ECMA-48: back to the line's begin, erase it; bold.
constexpr const char* kOver = "\r\x1b[2K\x1b[1m";
constexpr const char* kPlain = "\x1b[0m";

}  // namespace

HandTerminal standard_error() {
  return {[](const std::string& text) { std::fputs(text.c_str(), stderr); },
          isatty(STDERR_FILENO) == 1};
}

HandDisplay::HandDisplay(fs::path folder, HandTerminal terminal, LogSink& log)
    : folder_(std::move(folder)), terminal_(std::move(terminal)), log_(log) {}

void HandDisplay::show(Time now, const Instruction& instruction) {
  const std::lock_guard lock(mutex_);
  if (finished_) return;
  latest_ = instruction;
  if (!terminal_.is_live) write_line(instruction);
  if (next_ && now < *next_) return;
  next_ = now + kPeriod;
  write(instruction);
}

void HandDisplay::finish() {
  const std::lock_guard lock(mutex_);
  if (finished_ || !latest_) return;
  finished_ = true;
  write(*latest_);
  if (terminal_.is_live) terminal_.write("\n");
}

void HandDisplay::write(const Instruction& instruction) {
  if (terminal_.is_live) write_line(instruction);
  const camera::Sign sign = as_sign(instruction);
  if (folder_.empty() || sign_ == sign) return;
  sign_ = sign;
  write_picture(sign);
}

void HandDisplay::write_line(const Instruction& instruction) {
  const std::string words = in_words(instruction);
  if (terminal_.is_live) {
    if (line_ != words) terminal_.write(kOver + words + kPlain);
    line_ = words;
    return;
  }
  // How far it still is does not begin a new line, nor does standing on.
  const bool is_moving =
      instruction.kind == Instruction::Kind::Goal || instruction.kind == Instruction::Kind::Speed;
  const bool is_same = said_ && said_->kind == instruction.kind;
  if (is_same && (!is_moving || said_->command == instruction.command)) return;
  said_ = instruction;
  terminal_.write("hand: " + words + "\n");
}

void HandDisplay::write_picture(const camera::Sign& sign) {
  if (cannot_write_) return;
  const fs::path file = folder_ / "hand.png";
  try {
    fs::create_directories(folder_);
    camera::write_png(camera::draw_sign(sign), file);
  } catch (const std::runtime_error& error) {  // of the file system, too
    cannot_write_ = true;
    log_.write(Severity::Warning, error.what());
  }
}

}  // namespace eyebridge::hal
