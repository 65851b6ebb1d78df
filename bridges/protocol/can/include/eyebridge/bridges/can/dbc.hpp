#pragma once

#include <string>

namespace eyebridge::bridges::can {

/// Which DBC file to write.
struct DbcOptions {
  bool fd = false;  ///< S_LidarChunkFD instead of S_LidarChunk: both have one identifier, and a DBC
                    ///< file knows an identifier once.
  /// 0: one robot, identifiers of node 1, for tools that mask the node (0x7F0). 1 … 14: every robot
  /// with its own identifiers and names (R2_S_Pose), for tools that compare identifiers exactly.
  int robots = 0;
};

/// The protocol as a Vector DBC file, made from the table.
std::string write_dbc(const DbcOptions& options);

}  // namespace eyebridge::bridges::can
