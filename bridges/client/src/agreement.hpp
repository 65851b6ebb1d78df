#pragma once

#include "eyebridge/base/clock.hpp"
#include "eyebridge/bridges/io7/reply_parser.hpp"

namespace eyebridge::bridges {

/// Whether two replies to the same request, `apart` from each other, can both be right: what a
/// sensor may have changed meanwhile is allowed, counts of encoders by the fastest speed that can
/// be commanded. Bits, states and versions must be equal.
bool agree(const io7::Reply& a, const io7::Reply& b, Time apart);

}  // namespace eyebridge::bridges
