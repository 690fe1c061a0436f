// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew::bench {

inline constexpr double kPackedBudgetM = 1e-4;  ///< how far a packed clip may move a vertex

/// A skeleton with one clip, in both forms.
struct Character {
  std::string name;
  Skeleton skeleton;
  Animation animation;
  Clip clip;
  std::optional<Clip> packed;  ///< the same within kPackedBudgetM; for models and the biped only

  Character(std::string named, Skeleton s, Animation a);
  std::size_t joint_count() const { return skeleton.joint_count(); }
};

/// Generated characters, those of the showcase, and those of the corpus when there is one: models of at least sixteen
/// joints, up to three clips of each. Tracks are linear, since the plain GLM version samples no others.
const std::vector<std::shared_ptr<const Character>>& characters();

/// Skinned and animated files of the corpus whose clips the plain GLM version can play.
struct NamedScene {
  std::string name;
  std::shared_ptr<const Scene> scene;
};
const std::vector<NamedScene>& corpus_scenes();

}  // namespace sinew::bench
