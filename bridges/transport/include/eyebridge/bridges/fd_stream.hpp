#pragma once

#include <memory>
#include <string>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/bridges/byte_stream.hpp"

namespace eyebridge::bridges {

/// A stream over a connected socket or a terminal, which becomes non-blocking. `clock` must outlive
/// it. Reading and writing allocate nothing unless they fail.
std::unique_ptr<ByteStream> make_fd_stream(UniqueFd fd, std::string name, Clock& clock);

}  // namespace eyebridge::bridges
