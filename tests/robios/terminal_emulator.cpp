#include "terminal_emulator.hpp"

#include <algorithm>
#include <sstream>

namespace eyebridge::testing {
namespace {

std::vector<int> numbers_of(const std::string& parameters) {
  std::vector<int> numbers;
  std::istringstream in(parameters);
  for (std::string word; std::getline(in, word, ';');) {
    numbers.push_back(word.empty() ? 0 : std::stoi(word));
  }
  return numbers;
}

}  // namespace

TerminalEmulator::TerminalEmulator(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      cells_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)),
      bottom_(rows - 1) {}

std::size_t TerminalEmulator::index(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

const TerminalEmulator::Cell& TerminalEmulator::at(int column, int row) const {
  return cells_.at(index(column, row));
}

std::string TerminalEmulator::text(int row) const {
  std::string text;
  for (int column = 0; column < columns_; ++column) {
    const char32_t glyph = at(column, row).glyph;
    text += glyph < 256 ? static_cast<char>(glyph) : '#';
  }
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

void TerminalEmulator::resize(int columns, int rows) {
  TerminalEmulator other(columns, rows);
  for (int row = 0; row < std::min(rows, rows_); ++row) {
    for (int column = 0; column < std::min(columns, columns_); ++column) {
      other.cells_[other.index(column, row)] = at(column, row);
    }
  }
  columns_ = columns;
  rows_ = rows;
  cells_ = other.cells_;
  top_ = 0;
  bottom_ = rows - 1;
  now_.column = std::min(now_.column, columns - 1);
  now_.row = std::min(now_.row, rows - 1);
}

void TerminalEmulator::feed(std::string_view bytes) {
  for (const char byte : bytes) {
    const auto code = static_cast<std::uint8_t>(byte);
    if (reading_ == Reading::Escape) {
      escape(byte);
    } else if (reading_ == Reading::Sequence) {
      if (code >= 0x40) {
        sequence(byte);
      } else {
        parameters_ += byte;
      }
    } else if (following_ > 0) {
      code_ = code_ << 6 | (code & 0x3FU);
      if (--following_ == 0) character(code_);
    } else if (code >= 0xC0) {
      following_ = code >= 0xF0 ? 3 : code >= 0xE0 ? 2 : 1;
      code_ = code & (0x3FU >> following_);
    } else if (code < 0x20) {
      control(byte);
    } else {
      character(code);
    }
  }
}

void TerminalEmulator::character(char32_t code) {
  if (now_.wraps) {
    now_.column = 0;
    line_feed();
  }
  cells_[index(now_.column, now_.row)] = {code, now_.ink, now_.paper};
  now_.wraps = now_.column == columns_ - 1;
  if (!now_.wraps) ++now_.column;
}

void TerminalEmulator::control(char byte) {
  if (byte == '\x1b') {
    reading_ = Reading::Escape;
    return;
  }
  now_.wraps = false;
  if (byte == '\r') {
    now_.column = 0;
  } else if (byte == '\n') {
    line_feed();
  } else {
    unknown_ += "control " + std::to_string(byte) + "; ";
  }
}

void TerminalEmulator::escape(char byte) {
  reading_ = byte == '[' ? Reading::Sequence : Reading::Ground;
  parameters_.clear();
  if (byte == '7') {
    saved_ = now_;
  } else if (byte == '8') {
    now_ = saved_;
  } else if (byte == 'D') {
    line_feed();
  } else if (byte != '[') {
    unknown_ += std::string("escape ") + byte + "; ";
  }
}

void TerminalEmulator::sequence(char last) {
  reading_ = Reading::Ground;
  const bool sets = last == 'h';
  if (parameters_ == "?1000" && (sets || last == 'l')) {
    mouse_ = sets;
    return;
  }
  if (parameters_ == "?1006" && (sets || last == 'l')) {
    sgr_ = sets;
    return;
  }
  if (parameters_.find_first_not_of("0123456789;") != std::string::npos) {
    unknown_ += "sequence " + parameters_ + last + "; ";
    return;
  }
  const std::vector<int> numbers = numbers_of(parameters_);
  const auto number = [&](std::size_t i, int usual) {
    return i < numbers.size() && numbers[i] != 0 ? numbers[i] : usual;
  };
  if (last == 'm') {
    select_graphics();
    return;
  }
  now_.wraps = false;
  if (last == 'H') {
    now_.row = std::min(number(0, 1), rows_) - 1;
    now_.column = std::min(number(1, 1), columns_) - 1;
  } else if (last == 'A') {
    now_.row = std::max(now_.row - number(0, 1), 0);
  } else if (last == 'r') {
    top_ = number(0, 1) - 1;
    bottom_ = std::min(number(1, rows_), rows_) - 1;
    now_.row = now_.column = 0;
  } else if (last == 'J' && number(0, 0) == 2) {
    std::fill(cells_.begin(), cells_.end(), Cell{U' ', now_.ink, now_.paper});
  } else {
    unknown_ += "sequence " + parameters_ + last + "; ";
  }
}

void TerminalEmulator::select_graphics() {
  std::vector<int> numbers = numbers_of(parameters_);
  if (numbers.empty()) numbers = {0};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    int& colour = numbers[i] == 48 ? now_.paper : now_.ink;
    if (numbers[i] == 0) {
      now_.ink = now_.paper = kDefault;
    } else if ((numbers[i] == 38 || numbers[i] == 48) && i + 4 < numbers.size() &&
               numbers[i + 1] == 2) {
      colour = numbers[i + 2] << 16 | numbers[i + 3] << 8 | numbers[i + 4];
      i += 4;
    } else if ((numbers[i] == 38 || numbers[i] == 48) && i + 2 < numbers.size() &&
               numbers[i + 1] == 5) {
      colour = kPalette + numbers[i + 2];
      i += 2;
    } else if (numbers[i] >= 31 && numbers[i] <= 37) {  // programs colour what they print
      now_.ink = kPalette + numbers[i] - 30;
    } else {
      unknown_ += "attribute " + parameters_ + "; ";
      return;
    }
  }
}

void TerminalEmulator::line_feed() {
  if (now_.row != bottom_) {
    now_.row = std::min(now_.row + 1, rows_ - 1);
    return;
  }
  if (top_ == 0) history_.push_back(text(0));
  const auto row = [&](int r) { return cells_.begin() + static_cast<long>(index(0, r)); };
  std::copy(row(top_ + 1), row(bottom_) + columns_, row(top_));
  std::fill(row(bottom_), row(bottom_) + columns_, Cell{U' ', now_.ink, now_.paper});
}

}  // namespace eyebridge::testing
