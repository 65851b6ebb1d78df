#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "eyebridge/bridges/byte_stream.hpp"

namespace eyebridge::apps {

/// What passed a line.
struct LineCounts {
  std::uint64_t sent = 0;      ///< Bytes.
  std::uint64_t received = 0;  ///< Bytes.
  std::uint64_t writes = 0;    ///< Questions, as the line saw them.
  std::string first;           ///< The first bytes that came, at most kFirst.

  static constexpr std::size_t kFirst = 512;
};

/// `inner`, counting into `counts`, which must outlive it.
std::unique_ptr<bridges::ByteStream> make_counting(std::unique_ptr<bridges::ByteStream> inner,
                                                   LineCounts& counts);

}  // namespace eyebridge::apps
