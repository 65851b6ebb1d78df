#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/backend.hpp"

namespace eyebridge::robios {

class Session;

/// The error of a call whose device this robot does not have: names it, and in a simulated world
/// also the built-in robots that have it.
///
/// `kind` and `id` are those of files::robots_with(); `called` is what the program calls the device
/// (empty: its kind and number).
tl::unexpected<Error> no_device(Session& session, std::string_view kind, int id,
                                const std::string& called = "");

/// The same for what `robots` have: the caller looked them up.
tl::unexpected<Error> no_device(hal::Backend& backend, const std::string& called,
                                const std::vector<std::string>& robots);

}  // namespace eyebridge::robios
