#pragma once

#include <string>

namespace eyebridge::files {

/// Text as other systems and editors write it, as UTF-8 with "\n" at the ends of lines: UTF-16 (by
/// its mark, or its zeros), Latin-1 where it is no UTF-8, CR and CRLF, no-break blanks as blanks.
/// Other bytes stay, for check_text() to name. Throws ConfigError for UTF-32, and for UTF-16 that
/// breaks off.
std::string as_utf8(std::string bytes, const std::string& file);

}  // namespace eyebridge::files
