#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <asm/termbits.h>  // termios2, as in serial.cpp
#include <sys/socket.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::bridges {

/// The guard's own descriptor of a line, and how to open that line again. Uses system calls only.
class HeldLine {
 public:
  /// Takes over `line`. `device` is the path of a terminal; sockets know where they lead.
  void hold(UniqueFd line, const char* device);
  void close() { line_.reset(); }
  /// From now on other programs may have the terminal.
  void yield();
  /// Whether one has it: a new program, which stops the motors itself.
  [[nodiscard]] bool is_taken() const;
  [[nodiscard]] bool is_open() const { return line_.valid(); }
  [[nodiscard]] int descriptor() const { return line_.get(); }
  /// Opens a closed line again, with its settings; false when that fails. A terminal that has only
  /// a number (/dev/pts/7) stays closed: the number may belong to another device by now.
  bool reopen();
  /// One write of all; what the line does not take is left out. Closes a line that is lost.
  void write(std::span<const std::uint8_t> bytes);
  /// What is there; 0 when nothing is. Closes a line that is lost.
  std::size_t read(std::span<std::uint8_t> buffer);

 private:
  void close_if_lost(int error);
  bool reopen_terminal();
  bool reopen_socket();

  UniqueFd line_;
  const char* device_ = "";
  bool is_socket_ = false;
  termios2 settings_{};
  // Of a socket; a CAN interface is an address of this side.
  int domain_ = 0;
  int type_ = 0;
  int protocol_ = 0;
  sockaddr_storage address_{};
  socklen_t length_ = 0;
};

}  // namespace eyebridge::bridges
