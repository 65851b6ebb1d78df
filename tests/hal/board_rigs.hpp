#pragma once

#include <functional>
#include <memory>
#include <string>

#include "board/open_board.hpp"
#include "rigs.hpp"

namespace eyebridge::hal {

// A robot behind a line, for rows of the contract: who has the other end only makes the line.
//   {"Io7OverPty", [](double wall) { return io7_rig("serial:pty", pty_of(firmware(wall))); }, …}
// `url` carries the options (profile, node, hdt). The rigs live on the computer's clock.

using MakeStream = std::function<Result<std::unique_ptr<bridges::ByteStream>>(Clock& clock)>;
using MakeBus = std::function<std::unique_ptr<bridges::CanBus>(Clock& clock)>;

/// Over a line of bytes; `line` is called again after a loss.
Rig io7_rig(const std::string& url, MakeStream line);
/// Over a CAN bus.
Rig can_rig(const std::string& url, const MakeBus& bus);

}  // namespace eyebridge::hal
