// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/plan/run_plan.h"

namespace sinew::test {

struct SlowPrimitive {
  std::vector<Vec3<double>> positions, normals, tangents;
  std::vector<Vec4<double>> colors;
};

/// One frame in double precision, by plain loops over the animations, without plan, clips or jobs. It is the truth for
/// run_plan(). Vertices of skinned instances are in world space, others in mesh space.
struct SlowFrame {
  std::vector<Affined> model;
  std::vector<double> weights;
  std::vector<double> properties;
  std::vector<SlowPrimitive> primitives;  ///< those of all instances, in order
  std::vector<bool> mirrored;             ///< [instances]
  std::vector<Affined> world_from_mesh;   ///< [instances]
};

SlowFrame evaluate_slowly(const Scene& scene, const Needs& needs, const FrameInput& input);

}  // namespace sinew::test
