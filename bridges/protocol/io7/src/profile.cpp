#include "eyebridge/bridges/io7/profile.hpp"

#include "eyebridge/bridges/io7/command_table.hpp"

namespace eyebridge::bridges::io7 {

std::span<const std::uint8_t> bytes_of(Terminator terminator) {
  static constexpr std::array<std::uint8_t, 2> kCrLf = {'\r', '\n'};
  switch (terminator) {
    case Terminator::Cr:
      return std::span(kCrLf).first(1);
    case Terminator::Lf:
      return std::span(kCrLf).last(1);
    case Terminator::CrLf:
      break;
  }
  return kCrLf;
}

LetterSet documented_letters() {
  LetterSet letters;
  for (const Command& command : commands()) {
    if (command.documented) letters.insert(command.letter);
  }
  return letters;
}

}  // namespace eyebridge::bridges::io7
