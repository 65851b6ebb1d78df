#pragma once

#include "eyebridge/base/result.hpp"
#include "remote_robot/byte_ring.hpp"

namespace eyebridge::hal {

/// The layout of the shared memory of a line.
struct SharedLine {
  SharedRing to_world;
  SharedRing to_program;
};

/// The memory of a line: the world's end makes it and hands it over through the line's socket.
class LineMemory {
 public:
  /// Makes it and sends it. Throws std::system_error when the system gives none.
  static LineMemory offer(int socket);
  /// Waits for it. Disconnected when the other end is gone; Corrupt when what comes is no memory of
  /// this size.
  static Result<LineMemory> accept(int socket);

  ~LineMemory();
  LineMemory(LineMemory&& other) noexcept;
  LineMemory& operator=(LineMemory&&) = delete;

  [[nodiscard]] SharedLine& line() const { return *line_; }

 private:
  explicit LineMemory(int descriptor);

  SharedLine* line_ = nullptr;  ///< Null: mmap() failed, or moved from.
};

}  // namespace eyebridge::hal
