#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "dbc_scanner.hpp"
#include "eyebridge/bridges/dbc/database.hpp"

namespace eyebridge::bridges::dbc {

/// Reads one file.
class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : scan_(text, file) {}
  Database read();

 private:
  /// What a value of an attribute is of.
  struct Owner {
    std::string_view kind;  ///< "BO_", "SG_", another one, or none: the whole network.
    Message* message = nullptr;
    Signal* signal = nullptr;
  };
  struct LongName {
    std::size_t message = 0;
    std::optional<std::size_t> signal;
    std::string name;
  };
  struct Statement {
    std::string_view keyword;
    void (Reader::*read)();
    bool ends_with_line;  ///< Else with ';', after any number of lines.
  };
  static const std::vector<Statement>& statements();

  void read_statement();
  // dbc_reader.cpp: after their keyword.
  void symbols();
  void version();
  void nodes();
  void message();
  void signal();
  void selection();
  void value_type();
  void value_table();
  void values();
  // dbc_attributes.cpp
  void comment();
  void definition();
  void default_value();
  void attribute();
  void apply(const std::string& name, const std::string& value, const Owner& owner);
  void set(Message& message, std::string_view name, const std::string& value) const;
  void apply_defaults();
  void apply_long_names();

  std::vector<NamedValue> named_values();
  /// The message whose number comes next; null where the file has none.
  Message* message_reference();
  Signal* signal_reference(Message* message);
  Owner owner(std::string_view kind);
  std::string attribute_value();
  void multiplex_line(Signal& signal, std::string_view mark);
  void resolve(Message& message);
  [[nodiscard]] bool is_fd_format(const std::string& value) const;

  Scanner scan_;
  Database database_;
  std::unordered_map<std::uint64_t, std::size_t> by_number_;  ///< As the file writes identifiers.
  bool in_message_ = false;                                   ///< The last BO_ is one of ours.
  bool after_message_ = false;                                ///< There was one at all.
  std::map<std::string, std::vector<NamedValue>, std::less<>> tables_;
  std::map<std::string, std::vector<std::string>, std::less<>> enumerations_;
  std::map<std::string, std::string, std::less<>> defaults_;
  std::map<std::string, std::vector<std::size_t>, std::less<>> told_;  ///< Messages by attribute.
  std::vector<LongName> long_names_;  ///< Set at the end: until then statements use short ones.
};

}  // namespace eyebridge::bridges::dbc
