#pragma once

#include <cstdio>
#include <memory>
#include <string>

namespace eyebridge::apps {

/// A text that is written line by line: complete even when the process is killed.
using OutputFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// What such a text is, by which an earlier one is known.
struct OutputKind {
  const char* name;    ///< "trace"
  const char* flag;    ///< That names the file: "--trace".
  const char* header;  ///< Its first line.
};
inline constexpr OutputKind kTraceOutput{"trace", "--trace", "# eyebridge: what passed a line"};
inline constexpr OutputKind kPathOutput{"path", "--path", "t,robot,x,y,theta"};

/// The file at `path`, emptied, with its first line; null for "". Throws ConfigError when it cannot
/// be written, and for a file of another kind: that is not replaced.
OutputFile open_output(const std::string& path, const OutputKind& kind);

}  // namespace eyebridge::apps
