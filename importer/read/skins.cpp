// SPDX-License-Identifier: MIT
#include "importer/read/skins.h"

#include <string>

#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"
#include "importer/read/nodes.h"
#include "runtime/base/all_finite.h"

namespace sinew {
std::vector<Affine> read_inverse_bind_matrices(const gltf::Document& document, std::uint32_t index, IssueLog& log) {
  const tinygltf::Skin& skin = document.skins[index];
  const std::string place = pointer("skins", index, "inverseBindMatrices");
  std::vector<Affine> matrices(skin.joints.size());
  if (skin.joints.empty())
    log.report(Rule::skin_no_joints, pointer("skins", index, "joints"), "the skin moves nothing");
  if (skin.inverseBindMatrices == gltf::kAbsent) return matrices;
  const gltf::Accessor& accessor = document.accessors[skin.inverseBindMatrices];
  if (accessor.type != gltf::ElementType::mat4 || accessor.component_type != gltf::ComponentType::f32) {
    log.report(Rule::skin_matrices, place, "are not 4x4 matrices of floats");
    return matrices;
  }
  if (accessor.count < skin.joints.size()) {
    log.report(Rule::skin_matrices, place,
               std::to_string(accessor.count) + " matrices for " + std::to_string(skin.joints.size()) + " joints");
    return matrices;
  }
  const std::vector<float> numbers = read_floats(document, skin.inverseBindMatrices);
  for (std::size_t j = 0; j < matrices.size(); ++j) {
    const float* m = numbers.data() + 16 * j;
    if (!all_finite(std::span<const float>(m, 16))) {
      log.report(Rule::not_finite, place, "matrix " + std::to_string(j) + " holds NaN or infinity");
      return matrices;
    }
    if (!to_affine(m, matrices[j]))
      log.report(Rule::skin_matrix_row, place,
                 "the fourth row of matrix " + std::to_string(j) + " is not 0 0 0 1; it is ignored");
  }
  return matrices;
}

void check_common_root(const gltf::Document& document, std::uint32_t index,
                       const std::vector<std::uint32_t>& root_of_node, IssueLog& log) {
  const auto& joints = document.skins[index].joints;
  for (std::size_t j = 1; j < joints.size(); ++j)
    if (root_of_node[joints[j]] != root_of_node[joints[0]])
      return log.report(Rule::skin_common_root, pointer("skins", index, "joints", j),
                        "lies under another root than joint 0; each joint's own ancestors are used");
}

}  // namespace sinew
