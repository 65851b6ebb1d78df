#pragma once

#include <functional>
#include <memory>

#include "eyebridge/bridges/open.hpp"
#include "eyebridge/hal/registry.hpp"

namespace eyebridge::hal {

// Rows of the table of backends. The URL's options besides those of the line: `hdt=FILE` (else
// --hdt), for bytes `profile=io7` or `profile=io7vw` (which allows the undocumented v-omega
// letters), `timeout=MS`, `requests=text|bytes`, `order=msb|lsb`, for CAN `node=1`, or
// `dbc=FILE&map=FILE` for a robot with messages of its own. Opening finds the board and makes it
// ready, at speed 0. They throw ConfigError: for a wrong URL, and when there is no such board
// behind the line.

/// serial:DEVICE and tcp:HOST:PORT: a board that speaks IO7.
std::unique_ptr<Backend> open_io7_board(const BackendUrl& url, const BackendContext& context);
/// can:INTERFACE: a robot on a CAN bus.
std::unique_ptr<Backend> open_can_board(const BackendUrl& url, const BackendContext& context);

/// The same over a line at hand, named by `url`; for tests, and for lines without a scheme.
/// `open` is called again after a loss; `clock` is the one of the lines. Where it is virtual
/// nothing runs by itself: who moves it calls BoardBackend::step() and CanClient::pump().
std::unique_ptr<Backend> open_io7_board(
    const BackendUrl& url, const BackendContext& context,
    std::function<Result<std::unique_ptr<bridges::ByteStream>>()> open,
    std::unique_ptr<Clock> clock);
std::unique_ptr<Backend> open_can_board(const BackendUrl& url, const BackendContext& context,
                                        std::unique_ptr<bridges::CanBus> bus,
                                        std::unique_ptr<Clock> clock);

}  // namespace eyebridge::hal
