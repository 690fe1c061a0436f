// SPDX-License-Identifier: MIT
#include "importer/tool/model_size.h"

#include <algorithm>
#include <limits>

#include "importer/tool/poses/pose_sampler.h"
#include "runtime/animation/truth_pose.h"
#include "runtime/math/affine.h"

namespace sinew::tool {
namespace {

constexpr int kPosesOfClip = 8;

/// The longest side of the box around the joints at rest. If it is 0, that of the box over all clips.
double size_of_joints(const Scene& scene) {
  Aabb box;
  TruthPose pose;
  const auto size_with = [&](const Animation& animation, double time_s) {
    evaluate_truth(animation, scene.skeleton, time_s, pose);
    for (const Affined& model : pose.model) box.add(glm::vec3(translation_of(model)));
    const glm::vec3 sides = box.empty() ? glm::vec3(0.0f) : box.upper - box.lower;
    return static_cast<double>(std::max({sides.x, sides.y, sides.z}));
  };
  double size = size_with({}, 0.0);
  if (size > 0.0) return size;
  for (const Animation& animation : scene.animations)
    for (int i = 0; i < kPosesOfClip; ++i) size = size_with(animation, animation.duration_s * i / (kPosesOfClip - 1));
  return size;
}

}  // namespace

std::optional<RestBox> rest_box(const Scene& scene) {
  PoseSampler sampler(
      scene,
      {.linear = true, .dual_quaternion = false, .center_of_rotation = false, .vertices_per_primitive = kAllVertices});
  if (sampler.run(kNone, 0.0) != ErrorCode::ok) return std::nullopt;
  RestBox box;
  box.lower.fill(std::numeric_limits<double>::infinity());
  box.upper.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t p = 0; p < sampler.primitive_count(); ++p) {
    const PrimitivePose primitive = sampler.primitive(p);
    const std::vector<double>& positions = primitive.of(VertexKind::positions);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      box.lower[i % 3] = std::min(box.lower[i % 3], positions[i]);
      box.upper[i % 3] = std::max(box.upper[i % 3], positions[i]);
    }
  }
  if (box.lower[0] > box.upper[0]) return std::nullopt;
  return box;
}

double model_size_m(const Scene& scene) {
  const auto box = rest_box(scene);
  double size = kSizeWithoutVertices;
  if (!box) return std::max(size, size_of_joints(scene));
  for (std::size_t axis = 0; axis < 3; ++axis) size = std::max(size, box->upper[axis] - box->lower[axis]);
  return size;
}

double metres_of(const Length& length, const Scene& scene) {
  return length.of_model > 0.0 ? length.of_model * model_size_m(scene) : length.metres;
}

}  // namespace sinew::tool
