// SPDX-License-Identifier: MIT
#include "importer/vrm.h"

#include "runtime/retarget/humanoid_bones.h"

namespace sinew {

std::vector<std::uint32_t> humanoid_bones_of(const VrmCharacter& vrm) {
  std::vector<std::uint32_t> joints(kHumanoidBones.size(), kNone);
  bool has_any = false;
  for (const VrmBone& bone : vrm.bones)
    if (const std::uint32_t index = humanoid_bone(bone.name); index != kNone) {
      joints[index] = bone.joint;
      has_any = true;
    }
  if (!has_any) joints.clear();
  return joints;
}

}  // namespace sinew
