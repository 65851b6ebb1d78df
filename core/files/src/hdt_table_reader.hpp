#pragma once

#include <string>
#include <vector>

#include "eyebridge/files/hdt.hpp"
#include "text.hpp"

namespace eyebridge::files {

/// What uses a table or a name.
enum class HdtUse { Motor, Servo, Psd, Drive };

/// A name that a line of an HDT gives for something defined elsewhere in the file.
struct HdtReference {
  HdtUse use{};
  int id = 0;  ///< Of the device that has the line.
  std::string name;
  SourceLocation where;
};

/// Collects the tables of an HDT, and holds each to what uses it.
class HdtTableReader {
 public:
  /// `file` must outlive the reader.
  explicit HdtTableReader(const std::string& file) : file_(file) {}

  /// Takes `s` when it begins, continues or ends a table; throws ConfigError for a bad one.
  bool take(const Statement& s);
  /// Throws ConfigError when a table is still open after the last line.
  void finish(int last_line) const;
  /// The table that `use` names. Throws ConfigError when there is none, or when it is not of the
  /// length or range that such a device needs.
  [[nodiscard]] std::size_t index_for(const HdtReference& use) const;
  /// All tables, in their order; the reader is empty then.
  [[nodiscard]] std::vector<HdtTable> release() { return std::move(tables_); }

 private:
  struct Place {
    int line = 0;
    int column = 0;
  };
  void begin(const Statement& s);
  void add(const Statement& s, std::size_t from);

  const std::string& file_;
  std::vector<HdtTable> tables_;
  std::vector<std::vector<Place>> places_;  ///< Of each value of each table.
  bool open_ = false;
};

}  // namespace eyebridge::files
