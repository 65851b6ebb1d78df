#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "text.hpp"

namespace eyebridge::files {

/// A value of a property: a number, a string in quotes, or a word.
struct StageValue {
  std::string text;
  std::optional<double> number;
  SourceLocation where;
};

/// "size [ 16 16 0.8 ]" has three values, "color \"red\"" one.
struct StageProperty {
  std::vector<StageValue> values;
  SourceLocation where;
};

/// "floorplan ( ... )": a type, properties, and entities in it.
struct StageEntity {
  std::string type;  ///< As written, …
  std::string base;  ///< … and what its definitions make it in the end: "model".
  SourceLocation where;
  std::map<std::string, StageProperty> properties;
  std::vector<StageEntity> children;
};

/// Reads the worldfile `text`: its properties and entities, each with what its definition says, as
/// children of one of type "". `include` gives the text of a file that `include "..."` names. Where
/// there is no such file it warns, and gives nothing. Throws ConfigError for a text that is no
/// worldfile, and for more than 100,000 entities.
StageEntity read_stage_entities(
    std::string_view text, const std::string& file,
    const std::function<std::optional<std::string>(const std::string& name,
                                                   const SourceLocation& where)>& include);

}  // namespace eyebridge::files
