// SPDX-License-Identifier: MIT
#include "importer/build/check_skeletons.h"

#include <algorithm>
#include <string>
#include <vector>

#include "importer/file/json_pointer.h"

namespace sinew {
namespace {

/// Numbers joints so that every subtree is a range; "lies below" is then one comparison.
class Subtrees {
 public:
  explicit Subtrees(const JointOrder& order)
      : size_(order.parents.size(), 1), begin_(order.parents.size()), next_(order.parents.size()) {
    for (std::size_t j = size_.size(); j-- > 0;)
      if (order.parents[j] != kNone) size_[order.parents[j]] += size_[j];
    std::uint32_t next_root = 0;
    for (std::size_t j = 0; j < size_.size(); ++j) {
      std::uint32_t& next = order.parents[j] == kNone ? next_root : next_[order.parents[j]];
      begin_[j] = next;
      next += size_[j];
      next_[j] = begin_[j] + 1;
    }
  }

  bool lies_below(std::uint32_t joint, std::uint32_t root) const noexcept {
    // Unsigned arithmetic: also false if the joint lies before `root` and the joints below it.
    return begin_[joint] - begin_[root] < size_[root];
  }

 private:
  std::vector<std::uint32_t> size_, begin_, next_;
};

}  // namespace

void check_skeletons(const gltf::Document& document, const JointOrder& order, IssueLog& log) {
  const bool named = std::any_of(document.skins.begin(), document.skins.end(),
                                 [](const tinygltf::Skin& skin) { return skin.skeleton != gltf::kAbsent; });
  if (!named) return;
  const Subtrees subtrees(order);
  for (std::size_t s = 0; s < document.skins.size(); ++s) {
    const tinygltf::Skin& skin = document.skins[s];
    if (skin.skeleton == gltf::kAbsent) continue;
    const auto strays = std::find_if(skin.joints.begin(), skin.joints.end(), [&](std::uint32_t node) {
      return !subtrees.lies_below(order.joint_of_node[node], order.joint_of_node[skin.skeleton]);
    });
    if (strays != skin.joints.end())
      log.report(Rule::skin_skeleton, pointer("skins", s, "skeleton"),
                 "joint " + std::to_string(strays - skin.joints.begin()) + " does not lie below node " +
                     std::to_string(skin.skeleton) + "; each joint's own ancestors are used");
  }
}

}  // namespace sinew
