#pragma once

#include <string>
#include <string_view>

#include "eyebridge/base/result.hpp"

// The files that are written from the table.
namespace eyebridge::bridges::can {

/// Which DBC file to write.
struct DbcOptions {
  bool fd = false;  ///< S_LidarChunkFD instead of S_LidarChunk: both have one identifier, and a DBC
                    ///< file knows an identifier once.
  /// 1 … 14: every robot with its own identifiers and names (R2_S_Pose), for tools that compare
  /// identifiers exactly. 0: one robot, identifiers of node 1, for tools that mask the node
  /// (0x7F0).
  int robots = 14;
};

/// The protocol as a Vector DBC file.
std::string write_dbc(const DbcOptions& options);

/// `old`, the text of opcodes.h or SPECIFICATION.md, with its parts between the markers written
/// anew. Fails with Corrupt when a marker is missing.
Result<std::string> update_opcodes(std::string_view old);
Result<std::string> update_specification(std::string_view old);

}  // namespace eyebridge::bridges::can
