#pragma once

#include <memory>
#include <string_view>

#include "eyebridge/camera/source.hpp"

namespace eyebridge::camera {

// The functions behind the rows of the table in open.cpp. `rest` is the URL after the colon; a
// source is only opened after its check has passed.

/// Pictures of the simulated world; `rest` names the maker of the OpenGL context, or none, and has
/// options: fiducials=on|off (place_fiducials() of the default layout on the walls), light=0.01 … 4
/// (a factor on all colours).
void check_render_source(std::string_view rest, const SourceContext& context);
std::unique_ptr<Source> open_render_source(std::string_view rest, const SourceContext& context);

/// A test picture: colour bars and a moving bar-code of the frame's number; `rest` is empty.
void check_pattern_source(std::string_view rest, const SourceContext& context);
std::unique_ptr<Source> open_pattern_source(std::string_view rest, const SourceContext& context);

/// Pictures of a folder, a video or a recording; `rest` is PATH?end=…&fps=…&pick=….
void check_frames_source(std::string_view rest, const SourceContext& context);
std::unique_ptr<Source> open_frames_source(std::string_view rest, const SourceContext& context);
/// A live camera; `rest` is a camera's name with options, or empty: see v4l2/camera_url.hpp. Not in
/// virtual time.
void check_v4l2_source(std::string_view rest, const SourceContext& context);
std::unique_ptr<Source> open_v4l2_source(std::string_view rest, const SourceContext& context);

}  // namespace eyebridge::camera
