#include "scan_rays.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "polygon_fill.hpp"

#define EYEBRIDGE_RAY_TARGET
#define EYEBRIDGE_TILE_LANES 4

namespace eyebridge::mapping {

#include "scan_draw.ipp"
#include "scan_place.ipp"
#include "scan_tiles.ipp"

const RayCode kPlainRayCode{place_rays, draw_rays, apply_tiles};

void ScanRays::resize(std::size_t rays) {
  count = rays;
  for (std::vector<float>* each :
       {&x, &y, &sigma, &place, &reach, &clear, &own_from, &corner_x, &corner_y, &tip_x, &tip_y}) {
    each->resize(rays);
  }
  kind.resize(rays);
  level.resize(rays);
}

const RayCode& ray_code() {
#if defined(__x86_64__)
  static const RayCode& code = __builtin_cpu_supports("avx2") != 0 ? kAvx2RayCode : kPlainRayCode;
  return code;
#else
  return kPlainRayCode;
#endif
}

}  // namespace eyebridge::mapping
