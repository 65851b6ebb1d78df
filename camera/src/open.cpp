#include <array>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/camera/source.hpp"
#include "src/sources.hpp"

namespace eyebridge::camera {
namespace {

constexpr std::array<SourceFactory, 2> kSources{{
    {"render", "pictures of the simulated world (render:osmesa, render:egl)", &open_render_source},
    {"pattern", "colour bars with the frame's number, needs no world", &open_pattern_source},
}};

}  // namespace

std::span<const SourceFactory> source_table() { return kSources; }

std::unique_ptr<Source> open_source(const std::string& url, const SourceContext& context) {
  const std::string_view text = url;
  const std::size_t colon = text.find(':');
  const std::string_view scheme = text.substr(0, colon);
  const std::string_view rest =
      colon == std::string_view::npos ? std::string_view{} : text.substr(colon + 1);
  std::string known;
  for (const SourceFactory& factory : kSources) {
    if (factory.scheme == scheme) return factory.open(rest, context);
    known += (known.empty() ? "" : ", ") + std::string(factory.scheme);
  }
  throw ConfigError({"--camera"},
                    "camera source \"" + url + "\" is not known, expected one of: " + known);
}

}  // namespace eyebridge::camera
