// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/jobs/skin_linear.h"

namespace sinew {

/// How skinned vertices follow their joints.
enum class Skinning : std::uint8_t { linear, dual_quaternion };

/// What the consumer of frames asks for. A stage that neither the needs nor the scene call for is left out of the plan.
struct Needs {
  bool joints = true;         ///< model matrices of all joints
  bool positions = true;      ///< deformed vertex positions
  bool normals = true;
  bool tangents = true;
  bool bounds = false;        ///< boxes of the deformed instances (P14)
  Skinning skinning = Skinning::linear;
  std::vector<Skinning> instance_skinning;  ///< [instances] overrides `skinning` per mesh instance; empty = no override
  NormalRule normal_rule = NormalRule::linear;
};

}  // namespace sinew
