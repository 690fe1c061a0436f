// SPDX-License-Identifier: MIT
#include "importer/tool/cost/limb.h"

#include <algorithm>
#include <cmath>

#include "importer/topology/centers_of_rotation.h"
#include "samples/showcase/shapes.h"

namespace sinew::cost {
namespace {

constexpr float kLength = 4.0f, kRadius = 0.5f, kJoint = 2.0f;
constexpr float kBlendBegins = 1.2f, kBlendEnds = 2.8f;
constexpr std::uint32_t kColumns = 48, kRows = 64;
constexpr double kQuarterTurn = 1.5707963267948966, kTwist = 2.6179938779914944;  // 150 degrees

/// The influences of the limb. Its rows run from one end to the other, so that vertices with one influence come before
/// and after vertices with two.
VertexInfluences influences_of(const Primitive& limb) {
  VertexInfluences out;
  for (std::uint32_t v = 0; v < limb.vertex_count(); ++v) {
    const float along = std::clamp((limb.positions[v].y - kBlendBegins) / (kBlendEnds - kBlendBegins), 0.0f, 1.0f);
    const bool single = along <= 0.0f || along >= 1.0f, second_first = along > 0.5f;
    const auto first_influence = static_cast<std::uint32_t>(out.weights.size());
    out.joints.push_back(second_first ? 1 : 0);
    out.weights.push_back(second_first ? along : 1.0f - along);
    if (!single) {
      out.joints.push_back(second_first ? 0 : 1);
      out.weights.push_back(second_first ? 1.0f - along : along);
    }
    const std::uint32_t count = single ? 1 : 2;
    if (!out.groups.empty() && out.groups.back().influence_count == count)
      ++out.groups.back().vertex_count;
    else
      out.groups.push_back({v, 1, count, first_influence});
  }
  return out;
}

PosedSkin posed(const Limb& limb, const Vec3<double>& axis, double angle_rad) {
  LocalPose local = rest_pose(limb.skeleton);
  const Vec3<double> v = axis * std::sin(0.5 * angle_rad);
  local[1].rotation = quat_xyzw(v.x, v.y, v.z, std::cos(0.5 * angle_rad));
  return {limb.skin, model_pose(limb.skeleton, local)};
}

}  // namespace

Limb::Limb() {
  primitive = showcase::lathe(
      glm::vec3(0.0f), kLength, [](float) { return kRadius; }, kColumns, kRows);
  primitive.influences = influences_of(primitive);
  primitive.centers_of_rotation = centers_of_rotation(primitive);
  skeleton.parents = {kNone, 0};
  skeleton.rest.resize(2);
  skeleton.rest[1].translation.y = kJoint;
  skeleton.fixed_matrix_of = {kNone, kNone};
  skin.joints = {0, 1};
  skin.inverse_bind.resize(2);
  skin.inverse_bind[1].row[1].w = -kJoint;
  bent = posed(*this, {1.0, 0.0, 0.0}, kQuarterTurn);
  twisted = posed(*this, {0.0, 1.0, 0.0}, kTwist);
}

SkinnedPart part_of(const Limb& limb) {
  return {&limb.primitive,
          &limb.skin,
          &limb.skeleton,
          {limb.bent, limb.twisted},
          "a built-in limb of two joints, for want of skinned vertices"};
}

double volume_of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Vec3<double> a(positions[indices[i]]), b(positions[indices[i + 1]]), c(positions[indices[i + 2]]);
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum / 6.0;
}

}  // namespace sinew::cost
