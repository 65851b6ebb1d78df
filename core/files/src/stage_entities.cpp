#include "stage_entities.hpp"

#include <algorithm>

namespace eyebridge::files {
namespace {

constexpr std::size_t kMostEntities = 100'000;
constexpr std::size_t kMostStageTokens = 5'000'000;
constexpr int kMostDeep = 50;      // entities in entities
constexpr int kMostIncludes = 20;  // files in files

struct StageToken {
  enum class Kind { Word, Text, Number, Open, Close, OpenList, CloseList, End };
  Kind kind = Kind::End;
  std::string text;
  double number = 0;
  SourceLocation where;
};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Splits one file into tokens.
class StageTokens {
 public:
  StageTokens(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  StageToken next() {
    skip_blanks();
    StageToken token;
    token.where = {file_, line_, column()};
    if (at_ == text_.size()) return token;
    const char c = text_[at_];
    constexpr std::string_view kMarks = "()[]";
    constexpr StageToken::Kind kKinds[] = {StageToken::Kind::Open, StageToken::Kind::Close,
                                           StageToken::Kind::OpenList, StageToken::Kind::CloseList};
    if (const std::size_t mark = kMarks.find(c); mark != std::string_view::npos) {
      token.kind = kKinds[mark];
      token.text = c;
      ++at_;
    } else if (c == '"') {
      read_text(token);
    } else if (is_letter(c)) {
      read_word(token);
    } else if (is_digit(c) || c == '+' || c == '-' || c == '.') {
      read_number(token);
    } else {
      throw ConfigError(token.where,
                        "found " + in_quotes(text_.substr(at_, 1)) +
                            ": expected a word, a number, a text in quotes, or one of ( ) [ ]");
    }
    return token;
  }

 private:
  [[nodiscard]] int column() const { return static_cast<int>(at_ - line_start_) + 1; }
  void skip_blanks() {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '#') at_ = std::min(text_.find('\n', at_), text_.size());
      if (at_ == text_.size()) return;
      if (text_[at_] == '\n') {
        ++line_;
        line_start_ = at_ + 1;
      } else if (text_[at_] != ' ' && text_[at_] != '\t') {
        return;
      }
    }
  }
  void read_text(StageToken& token) {
    const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
    if (end == std::string_view::npos || text_[end] == '\n') {
      throw ConfigError(token.where, "a text without its closing quote");
    }
    token.kind = StageToken::Kind::Text;
    token.text = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
  }
  /// "block[0].point[12]" is one word; "size[1 1]" is a word and a list.
  void read_word(StageToken& token) {
    const std::size_t begin = at_;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '[') {
        std::size_t close = at_ + 1;
        while (close < text_.size() && is_digit(text_[close])) ++close;
        if (close == at_ + 1 || close == text_.size() || text_[close] != ']') break;
        at_ = close + 1;
      } else if (is_letter(c) || is_digit(c) || c == '.' || c == '-') {
        ++at_;
      } else {
        break;
      }
    }
    token.kind = StageToken::Kind::Word;
    token.text = text_.substr(begin, at_ - begin);
  }
  void read_number(StageToken& token) {
    std::size_t end = at_;
    const auto belongs = [](char c) {
      return is_digit(c) || is_letter(c) || c == '+' || c == '-' || c == '.';
    };
    while (end < text_.size() && belongs(text_[end])) ++end;
    token.kind = StageToken::Kind::Number;
    token.text = text_.substr(at_, end - at_);
    const auto number = parse_number(token.text);
    if (!number) {
      throw ConfigError(token.where, "found " + in_quotes(token.text) + ": expected a number");
    }
    token.number = *number;
    at_ = end;
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 1;
};

class StageParser {
 public:
  using Include =
      std::function<std::optional<std::string>(const std::string&, const SourceLocation&)>;
  explicit StageParser(const Include& include) : include_(include) {}

  StageEntity read(std::string_view text, const std::string& file) {
    StageEntity world;
    world.where = {file, 0, 0};
    file_into(world, text, file, 0);
    return world;
  }

 private:
  /// All of a file becomes part of `entity`.
  void file_into(StageEntity& entity, std::string_view text, const std::string& file, int depth) {
    StageTokens tokens(text, file);
    StageToken token = take(tokens);
    while (token.kind != StageToken::Kind::End) {
      if (token.kind == StageToken::Kind::Word && token.text == "include") {
        include_into(entity, tokens, depth);
        token = take(tokens);
      } else {
        item_into(entity, tokens, token, 0);
      }
    }
  }

  void include_into(StageEntity& entity, StageTokens& tokens, int depth) {
    const StageToken name = take(tokens);
    if (name.kind != StageToken::Kind::Text) {
      throw ConfigError(name.where, "include: expected the name of a file in quotes");
    }
    if (depth == kMostIncludes) {
      throw ConfigError(name.where, "files that include files, more than 20 deep");
    }
    if (const auto text = include_(name.text, name.where)) {
      check_text(*text, name.text);
      file_into(entity, *text, name.text, depth + 1);
    }
  }

  /// One property, entity or definition that begins with `token`; the token after it is in `token`
  /// then.
  void item_into(StageEntity& entity, StageTokens& tokens, StageToken& token, int depth) {
    if (token.kind != StageToken::Kind::Word) {
      throw ConfigError(token.where, "found " + in_quotes(token.text) +
                                         ": expected the name of a property or an entity");
    }
    if (token.text == "define") {
      define(tokens, depth);
      token = take(tokens);
      return;
    }
    const StageToken name = std::move(token);
    token = take(tokens);
    if (token.kind == StageToken::Kind::Open) {
      entity.children.push_back(begun(name));
      entity_into(entity.children.back(), tokens, depth + 1);
      token = take(tokens);
      return;
    }
    StageProperty property;
    property.where = name.where;
    if (token.kind == StageToken::Kind::OpenList) {
      for (token = take(tokens); token.kind != StageToken::Kind::CloseList; token = take(tokens)) {
        property.values.push_back(value_of(token));
      }
      token = take(tokens);
    } else if (token.kind == StageToken::Kind::Text || token.kind == StageToken::Kind::Number) {
      property.values.push_back(value_of(token));
      token = take(tokens);
    } else {
      throw ConfigError(token.where, "found " + in_quotes(token.text) + ": expected the value of " +
                                         in_quotes(name.text) + ", or ( for an entity");
    }
    entity.properties[name.text] = std::move(property);
  }

  void entity_into(StageEntity& entity, StageTokens& tokens, int depth) {
    if (depth > kMostDeep) throw ConfigError(entity.where, "entities more than 50 deep");
    StageToken token = take(tokens);
    while (token.kind != StageToken::Kind::Close) {
      if (token.kind == StageToken::Kind::End) {
        throw ConfigError(entity.where, "'" + entity.type + " (' without its ')'");
      }
      item_into(entity, tokens, token, depth);
    }
  }

  void define(StageTokens& tokens, int depth) {
    const StageToken name = take(tokens);
    const StageToken parent = take(tokens);
    if (name.kind != StageToken::Kind::Word || parent.kind != StageToken::Kind::Word) {
      throw ConfigError(name.where, "define: expected a name, then what it is one of");
    }
    const StageToken open = take(tokens);
    if (open.kind != StageToken::Kind::Open) throw ConfigError(open.where, "define: expected (");
    StageEntity entity = begun(parent);
    entity_into(entity, tokens, depth + 1);
    definitions_[name.text] = std::move(entity);
  }

  /// An entity with all that the definition of its type says.
  StageEntity begun(const StageToken& name) {
    StageEntity entity;
    const auto found = definitions_.find(name.text);
    if (found != definitions_.end()) {
      count(found->second, name.where);
      entity = found->second;
    } else {
      entity.base = name.text;
    }
    if (++entities_ > kMostEntities) throw ConfigError(name.where, "more than 100000 entities");
    entity.type = name.text;
    entity.where = name.where;
    return entity;
  }
  void count(const StageEntity& entity, const SourceLocation& where) {
    entities_ += entity.children.size();
    if (entities_ > kMostEntities) throw ConfigError(where, "more than 100000 entities");
    for (const StageEntity& child : entity.children) count(child, where);
  }

  StageValue value_of(const StageToken& token) {
    switch (token.kind) {
      case StageToken::Kind::Number:
        return {token.text, token.number, token.where};
      case StageToken::Kind::Text:
      case StageToken::Kind::Word:
        return {token.text, std::nullopt, token.where};
      default:
        throw ConfigError(token.where, token.kind == StageToken::Kind::End
                                           ? "a list without its ']'"
                                           : "found " + in_quotes(token.text) + " in a list");
    }
  }

  StageToken take(StageTokens& tokens) {
    StageToken token = tokens.next();
    if (++tokens_ > kMostStageTokens) throw ConfigError(token.where, "more than 5000000 words");
    return token;
  }

  const Include& include_;
  std::map<std::string, StageEntity> definitions_;
  std::size_t entities_ = 0;
  std::size_t tokens_ = 0;
};

}  // namespace

StageEntity read_stage_entities(
    std::string_view text, const std::string& file,
    const std::function<std::optional<std::string>(const std::string&, const SourceLocation&)>&
        include) {
  check_text(text, file);
  return StageParser(include).read(text, file);
}

}  // namespace eyebridge::files
