#pragma once

#include <string_view>

#include "eyebridge/base/result.hpp"
#include "eyebridge/bridges/io7/profile.hpp"

namespace eyebridge::bridges::io7 {

/// Reads the letters out of a board's answer to `h`.
///
/// The form of the list is not documented, so a line counts only when it clearly starts with a
/// letter: `m motor speed`, `m: …`, `m - …`, `'m' …`, `<m> …`, `* m`, `1) m`, or the letter alone.
/// A list in one single line, `h O m M …`, is read too. Everything else is taken for a title and
/// skipped: a letter that is missed is only unused, one that is invented would be sent.
/// Fails with Corrupt when the text holds bytes that no text has, or names neither `h` nor `v`:
/// then it is no command list of such a board.
Result<LetterSet> parse_help(std::string_view text);

}  // namespace eyebridge::bridges::io7
