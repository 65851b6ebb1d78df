#pragma once

#include <QImage>

#include "eyebridge/files/floor_plan.hpp"

namespace eyebridge::gui {

/// The outlines of what is dark in `picture`, as files::read_floor_plan(). Transparent pixels are
/// light. Throws ConfigError, also for a picture without pixels.
files::FloorPlan read_floor_plan(const QImage& picture, const files::FloorPlanOptions& options);

}  // namespace eyebridge::gui
