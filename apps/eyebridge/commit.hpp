#pragma once

#include <string_view>

namespace eyebridge::apps {

/// The commit that this was built from: "commit 4aec93400b2f", with "-modified" where files that
/// git knows had been changed, or "unknown commit".
std::string_view commit();

}  // namespace eyebridge::apps
