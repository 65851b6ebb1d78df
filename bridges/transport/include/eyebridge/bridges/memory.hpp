#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "eyebridge/bridges/byte_stream.hpp"
#include "eyebridge/bridges/can_bus.hpp"

namespace eyebridge::bridges {

/// Two ends of one line in memory, for two threads or for one. Each direction holds `capacity`
/// bytes before a writer has to wait. With a virtual `clock` a wait ends only at its deadline.
/// `clock` must outlive both.
std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>> make_memory_streams(
    Clock& clock, std::size_t capacity = 65536);
/// The same for two sides that live in times of their own: each end's deadlines are in the time of
/// its clock, which must outlive that end alone.
std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>> make_memory_streams(
    Clock& first, Clock& second, std::size_t capacity = 65536);

/// A CAN bus in memory with any number of nodes. Not modelled: bit rate, arbitration, missing
/// acknowledgements. A sender waits until every other node has room, so nothing is dropped.
class MemoryCan {
 public:
  /// `capacity` frames wait at each node; `fd` allows CAN FD frames. `clock` must outlive all
  /// nodes.
  explicit MemoryCan(Clock& clock, std::size_t capacity = 512, bool fd = true);
  ~MemoryCan();
  MemoryCan(const MemoryCan&) = delete;
  MemoryCan& operator=(const MemoryCan&) = delete;

  /// A new node; it may outlive this object. Once a node has had company and all others are gone,
  /// it is Disconnected until another one comes. Any thread.
  std::unique_ptr<CanBus> connect(std::string name);

  /// Gives every node `frame` as a report of its controller, as real controllers do. Any thread.
  void report(const CanFrame& error_frame);

 private:
  struct Shared;
  class Node;
  std::shared_ptr<Shared> shared_;
};

}  // namespace eyebridge::bridges
