// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "importer/vrm.h"
#include "runtime/animation/skeleton.h"
#include "runtime/procedures/constraints/node_constraints.h"
#include "runtime/procedures/springs/spring_setup.h"

namespace sinew {

/// Springs of a VRM file, for compile_springs.
struct VrmSprings {
  SpringSetup setup;
  std::vector<std::string> left_out;  ///< a sentence for each joint or collider that cannot be used
};

/// Springs of a character. A joint of VRM 1.0 swings with its tail at the next joint of the list; the last one only
/// ends the chain. In VRM 0, all joints below a root swing, and a joint without children has a tail of 7 cm.
/// in   skeleton  of the scene that the character belongs to
/// cost O(joints + colliders), allocates
VrmSprings spring_setup_of(const VrmCharacter& vrm, const Skeleton& skeleton);

/// Constraints of a character, for sort_constraints.
/// cost O(constraints), allocates
std::vector<NodeConstraint> node_constraints_of(const VrmCharacter& vrm);

}  // namespace sinew
