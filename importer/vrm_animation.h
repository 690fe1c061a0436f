// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "importer/vrm.h"
#include "runtime/animation/bone_animation.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Expressions and gaze of a VRM animation, as tracks of a character.
struct FaceTracks {
  std::vector<BoneAnimation> eyes;       ///< rotations, if the eyes of the character are joints
  std::vector<WeightAnimation> weights;  ///< one for each instance that expressions of the clip move
  std::vector<std::string> not_found;    ///< moved expressions that the character lacks, or that move no morph target
};

/// Plays the expressions and the gaze of a clip (VRMC_vrm_animation) on a character. Its ranges, overrides and binary
/// expressions apply.
/// eq   value(t) = x translation of the expression's joint, clamped to [0, 1];  weights = rest + those of ExpressionsJob
///      gaze(t) = rotation of its joint times the axis z of the face, as a direction of look_along()
///      at all key times of the clip's expressions and gaze. Where one is not linear, also every 1/60 s
/// in   from   data of the clip's file;   to, scene  the character
/// cost O(keys * binds), allocates
FaceTracks face_tracks(const Animation& clip, const VrmCharacter& from, const VrmCharacter& to, const Scene& scene);

}  // namespace sinew
