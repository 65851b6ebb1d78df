#include "remote_robot/byte_ring.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace eyebridge::hal {
namespace {

constexpr std::uint32_t kRoom = SharedRing::kRoom;

tl::unexpected<Error> impossible(std::uint32_t filled) {
  return fail(Errc::Corrupt, fmt::format("found {} bytes in a line that has room for {}: the other "
                                         "process has written over it",
                                         filled, kRoom));
}

/// Calls copy(place in the ring, offset, count) for the one or two pieces of `count` bytes.
template <typename Copy>
void in_pieces(std::uint32_t position, std::size_t count, Copy copy) {
  const std::size_t begin = position % kRoom;
  const std::size_t first = std::min<std::size_t>(count, kRoom - begin);
  if (first > 0) copy(begin, std::size_t{0}, first);
  if (first < count) copy(std::size_t{0}, first, count - first);
}

// Sleeping and waking (Dekker's pattern): a process that goes to sleep sets its flag, then checks
// the ring again; a process that changed the ring then checks the flag. All four accesses are
// sequentially consistent, so at least one of the two sees the other. The writes are exchanges:
// qemu-user 7.2 on x86-64 reorders a sequentially consistent store of arm64 with a later load.

void say(std::atomic<std::uint32_t>& word, std::uint32_t value) { word.exchange(value); }

bool take(std::atomic<std::uint32_t>& sleeps) { return sleeps != 0 && sleeps.exchange(0) != 0; }

}  // namespace

Result<std::size_t> RingWriter::write(std::span<const std::uint8_t> bytes) {
  const std::uint32_t filled = written_ - ring_.read.load(std::memory_order_acquire);
  if (filled > kRoom) return impossible(filled);
  const std::size_t count = std::min<std::size_t>(bytes.size(), kRoom - filled);
  in_pieces(written_, count, [&](std::size_t place, std::size_t offset, std::size_t length) {
    std::memcpy(ring_.bytes + place, bytes.data() + offset, length);
  });
  written_ += static_cast<std::uint32_t>(count);
  say(ring_.written, written_);
  return count;
}

bool RingWriter::is_full() const { return written_ - ring_.read == kRoom; }
bool RingWriter::must_wake() const { return take(ring_.reader_sleeps); }
void RingWriter::set_asleep(bool asleep) const { say(ring_.writer_sleeps, asleep ? 1 : 0); }

Result<std::size_t> RingReader::read(std::span<std::uint8_t> room) {
  const std::uint32_t filled = ring_.written.load(std::memory_order_acquire) - read_;
  if (filled > kRoom) return impossible(filled);
  const std::size_t count = std::min<std::size_t>(room.size(), filled);
  in_pieces(read_, count, [&](std::size_t place, std::size_t offset, std::size_t length) {
    std::memcpy(room.data() + offset, ring_.bytes + place, length);
  });
  read_ += static_cast<std::uint32_t>(count);
  say(ring_.read, read_);
  return count;
}

bool RingReader::is_empty() const { return ring_.written == read_; }

bool RingReader::must_wake() const { return take(ring_.writer_sleeps); }
void RingReader::set_asleep(bool asleep) const { say(ring_.reader_sleeps, asleep ? 1 : 0); }

}  // namespace eyebridge::hal
