// SPDX-License-Identifier: MIT
#include "importer/tool/model_size.h"

#include <algorithm>
#include <limits>

#include "importer/tool/poses/pose_sampler.h"

namespace sinew::tool {

double model_size_m(const Scene& scene) {
  PoseSampler sampler(
      scene,
      {.linear = true, .dual_quaternion = false, .center_of_rotation = false, .vertices_per_primitive = kAllVertices});
  if (sampler.run(kNone, 0.0) != ErrorCode::ok) return kSizeWithoutVertices;
  double lower[3], upper[3];
  std::fill_n(lower, 3, std::numeric_limits<double>::infinity());
  std::fill_n(upper, 3, -std::numeric_limits<double>::infinity());
  for (std::size_t p = 0; p < sampler.primitive_count(); ++p) {
    const PrimitivePose primitive = sampler.primitive(p);
    const std::vector<double>& positions = primitive.of(VertexKind::positions);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      lower[i % 3] = std::min(lower[i % 3], positions[i]);
      upper[i % 3] = std::max(upper[i % 3], positions[i]);
    }
  }
  double size = kSizeWithoutVertices;
  for (int axis = 0; axis < 3; ++axis) size = std::max(size, upper[axis] - lower[axis]);
  return size;
}

double metres_of(const Length& length, const Scene& scene) {
  return length.of_model > 0.0 ? length.of_model * model_size_m(scene) : length.metres;
}

}  // namespace sinew::tool
