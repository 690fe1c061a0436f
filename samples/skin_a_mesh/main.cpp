// SPDX-License-Identifier: MIT
// A tube around two joints, the upper one twisted about the tube's axis. Linear blending narrows the middle of the
// tube, at 180 degrees to a point. Dual quaternions keep its radius.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <sinew/deform_jobs.h>
#include <sinew/math.h>
#include <sinew/pose_jobs.h>
#include <glm/vec3.hpp>

namespace {

using namespace sinew;

constexpr std::uint32_t kRings = 9, kSides = 12;
constexpr float kLength_m = 2.0f, kTwoPi = 6.28318531f;

struct Tube {
  std::vector<glm::vec3> positions, normals;
  VertexInfluences influences;
};

/// Vertices are grouped by number of influences: the rings at both ends follow one joint, those between follow two.
Tube make_tube() {
  Tube tube;
  const auto add_ring = [&](std::size_t ring) {
    const float t = static_cast<float>(ring) / (kRings - 1);
    for (std::size_t side = 0; side < kSides; ++side) {
      const float angle = kTwoPi * static_cast<float>(side) / kSides;
      tube.normals.push_back({std::cos(angle), 0.0f, std::sin(angle)});
      tube.positions.push_back(tube.normals.back() + glm::vec3(0.0f, kLength_m * t, 0.0f));
      if (ring == 0 || ring == kRings - 1) {
        tube.influences.joints.push_back(ring == 0 ? 0 : 1);
        tube.influences.weights.push_back(1.0f);
        continue;
      }
      const std::uint16_t heavier = t > 0.5f ? 1 : 0;  // the heaviest influence comes first
      tube.influences.joints.insert(tube.influences.joints.end(), {heavier, static_cast<std::uint16_t>(1 - heavier)});
      tube.influences.weights.insert(tube.influences.weights.end(), {std::fmax(t, 1.0f - t), std::fmin(t, 1.0f - t)});
    }
  };
  add_ring(0);
  add_ring(kRings - 1);
  for (std::size_t ring = 1; ring + 1 < kRings; ++ring) add_ring(ring);
  const auto vertices = static_cast<std::uint32_t>(tube.positions.size());
  tube.influences.groups = {{0, 2 * kSides, 1, 0}, {2 * kSides, vertices - 2 * kSides, 2, 2 * kSides}};
  return tube;
}

/// Radius of the ring in the middle of the tube.
float middle_radius_m(const std::vector<glm::vec3>& positions) {
  const glm::vec3& v = positions[(2 + kRings / 2 - 1) * kSides];
  return std::sqrt(v.x * v.x + v.z * v.z);
}

void require(ErrorCode code) {
  if (code == ErrorCode::ok) return;
  std::fprintf(stderr, "%s\n", describe(code).data());
  std::exit(1);
}

struct Radii {
  float linear_m, dual_quaternion_m;
};

Radii twist(const Tube& tube, float angle_rad) {
  // Two joints, one above the other on the tube's axis. An inverse bind matrix undoes a joint's place in the bind pose.
  Skin skin;
  skin.joints = {0, 1};
  skin.inverse_bind = {Affine{}, Affine{{{1, 0, 0, 0}, {0, 1, 0, -kLength_m}, {0, 0, 1, 0}}}};
  const Affine upper = affine_from_transform(
      Transform{.translation = {0, kLength_m, 0},
                .rotation = quat_xyzw(0.0f, std::sin(angle_rad / 2), 0.0f, std::cos(angle_rad / 2))});
  const std::array<Affine, 2> world = {Affine{}, upper};

  std::array<JointMatrix, 2> palette;
  const JointPaletteJob to_palette{.skin = &skin, .model = world, .palette = palette};
  require(run(to_palette));

  const VertexInput in{.positions = tube.positions, .normals = tube.normals, .tangents = {}};
  std::vector<glm::vec3> positions(tube.positions.size()), normals(positions.size());
  const VertexOutput out{.positions = positions, .normals = normals, .tangents = {}};

  const SkinLinearJob linear{.influences = &tube.influences, .palette = palette, .vertices = in, .out = out};
  require(run(linear));
  const float linear_m = middle_radius_m(positions);

  std::array<RigidStretch, 2> split;
  bool any_stretch = false;
  const SplitPaletteJob to_split{.palette = palette, .split = split, .any_stretch = &any_stretch};
  require(run(to_split));
  const SkinDualQuaternionJob dual{
      .influences = &tube.influences, .split = split, .any_stretch = any_stretch, .vertices = in, .out = out};
  require(run(dual));
  return {linear_m, middle_radius_m(positions)};
}

}  // namespace

int main(int argc, char** argv) {
  char* end = nullptr;
  const double most_deg = argc < 2 ? 179.0 : std::strtod(argv[1], &end);
  if (argc > 2 || (end && (end == argv[1] || *end)) || !(most_deg > 0.0 && most_deg < 180.0)) {
    std::fprintf(stderr, "usage: skin_a_mesh [DEGREES, more than 0 and less than 180]\n");
    return 2;
  }

  const Tube tube = make_tube();
  std::printf("radius of the middle ring, 1 m at rest\n  twist      linear   dual quaternion\n");
  bool as_known = true;
  for (int step = 0; step <= 4; ++step) {
    const double angle_rad = most_deg * step / 4 * 3.14159265358979 / 180.0;
    const auto [linear_m, dual_quaternion_m] = twist(tube, static_cast<float>(angle_rad));
    std::printf("  %5.1f deg  %7.4f  %7.4f m\n", most_deg * step / 4, linear_m, dual_quaternion_m);
    // The mean of two matrices keeps cos(angle / 2) of the radius; a blended rotation keeps all of it (hard case N20).
    as_known =
        as_known && std::fabs(linear_m - std::cos(angle_rad / 2)) < 1e-5 && std::fabs(dual_quaternion_m - 1.0f) < 1e-5f;
  }
  return as_known ? 0 : 1;
}
