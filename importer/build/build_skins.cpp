// SPDX-License-Identifier: MIT
#include "importer/build/build_skins.h"

#include <utility>

#include "importer/build/check_skeletons.h"
#include "importer/read/skins.h"

namespace sinew {

std::vector<Skin> build_skins(const gltf::Document& document, const JointOrder& order, IssueLog& log) {
  std::vector<Skin> skins;
  skins.reserve(document.skins.size());
  for (std::uint32_t s = 0; s < document.skins.size(); ++s) {
    const tinygltf::Skin& source = document.skins[s];
    Skin skin;
    skin.name = source.name;
    for (const std::uint32_t node : source.joints) skin.joints.push_back(order.joint_of_node[node]);
    skin.inverse_bind = read_inverse_bind_matrices(document, s, log);
    if (source.skeleton != gltf::kAbsent) skin.skeleton_root = order.joint_of_node[source.skeleton];
    check_common_root(document, s, order.root_of_node, log);
    skins.push_back(std::move(skin));
  }
  check_skeletons(document, order, log);
  return skins;
}

}  // namespace sinew
