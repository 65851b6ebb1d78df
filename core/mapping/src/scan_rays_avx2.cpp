#include "scan_rays.hpp"

#if defined(__x86_64__)

#include <algorithm>
#include <array>
#include <cstring>

#include "polygon_fill.hpp"

// Without fma: the same roundings as everywhere else.
#define EYEBRIDGE_RAY_TARGET __attribute__((target("avx2")))
#define EYEBRIDGE_TILE_LANES 8

namespace eyebridge::mapping {

#include "scan_draw.ipp"
#include "scan_place.ipp"
#include "scan_tiles.ipp"

const RayCode kAvx2RayCode{place_rays, draw_rays, apply_tiles};

}  // namespace eyebridge::mapping

#endif
