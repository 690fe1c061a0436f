// SPDX-License-Identifier: MIT
#include "runtime/animation/truth_pose.h"

namespace sinew {

void model_from_local(const Skeleton& skeleton, std::span<const Transformd> local, std::span<Affined> model) {
  for (std::size_t j = 0; j < local.size(); ++j) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[j], parent = skeleton.parents[j];
    model[j] = fixed == kNone ? affine_from_transform(local[j]) : affine_cast<double>(skeleton.fixed_matrices[fixed]);
    if (parent != kNone) model[j] = model[parent] * model[j];
  }
}

void evaluate_truth(const Animation& animation, const Skeleton& skeleton, double time_s, TruthPose& out) {
  const std::size_t joints = skeleton.joint_count();
  out.local.resize(joints);
  out.model.resize(joints);
  for (std::size_t j = 0; j < joints; ++j) out.local[j] = in_double(skeleton.rest[j]);
  // If two tracks move the same property, the last one counts, as in compiled clips.
  for (const BoneAnimation& bone : animation.bones)
    out.local[bone.joint] = bone.interpolate<double>(time_s, out.local[bone.joint]);
  model_from_local(skeleton, out.local, out.model);
}

}  // namespace sinew
