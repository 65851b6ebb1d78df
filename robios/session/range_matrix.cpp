#include <algorithm>

#include "convert.hpp"
#include "eyebridge.h"
#include "guarded.hpp"
#include "no_device.hpp"

int EYEBRIDGERangeMatrixGet(int matrix, int distance[]) {
  using namespace eyebridge;
  return robios::guarded("EYEBRIDGERangeMatrixGet", 1,
                         [&](robios::Session& session) -> Result<int> {
                           if (distance == nullptr) return robios::null_pointer();
                           hal::RangeMatrix* device = session.backend().range_matrix(matrix);
                           if (device == nullptr) return robios::no_device(session, "tof", matrix);
                           return device->read().map([&](const hal::RangeMatrix::Ranges& ranges) {
                             std::ranges::transform(ranges, distance, robios::to_mm);
                             return 0;
                           });
                         });
}
