#include "config/toml_guard.hpp"

namespace eyebridge::hal {
namespace {

bool is_beyond_ascii(char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; }
/// A byte that goes on a UTF-8 character: not counted as a column.
bool goes_on(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Walks through a text, keeping count of lines and columns and of what the quotes mean.
class Walk {
 public:
  Walk(std::string_view text, const std::string& file) : text_(text), where_{file, 1, 1} {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  }

  void run() {
    while (!text_.empty()) {
      const char c = text_.front();
      if (c == '\n') {
        state_ = kOutside;
      } else if (state_ == kOutside) {
        look_outside(c);
      } else if (state_ == c) {
        state_ = kOutside;
      } else if (state_ == '"' && c == '\\' && text_.size() > 1 && text_[1] != '\n') {
        step();
      }
      step();
    }
  }

 private:
  static constexpr char kOutside = 0;
  static constexpr char kComment = '\n';  // ends as a quoted text does, by its own character

  void look_outside(char c) {
    if (is_beyond_ascii(c)) {
      throw ConfigError(where_,
                        "found a character beyond ASCII, expected those only in quotes or "
                        "after #");
    }
    if (c == '#') state_ = kComment;
    if (c != '"' && c != '\'') return;
    if (text_.size() > 2 && text_[1] == c && text_[2] == c) {
      throw ConfigError(where_, "found three quotes, expected a text of one line");
    }
    state_ = c;
  }

  void step() {
    if (text_.front() == '\n') {
      ++where_.line;
      where_.column = 1;
    } else if (text_.size() < 2 || !goes_on(text_[1])) {
      ++where_.column;
    }
    text_.remove_prefix(1);
  }

  std::string_view text_;
  SourceLocation where_;
  char state_ = kOutside;  ///< The quote that ends the text we are in, or one of the above.
};

}  // namespace

void check_toml_text(std::string_view text, const std::string& file) { Walk(text, file).run(); }

}  // namespace eyebridge::hal
