// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew::bench {

inline constexpr double kPackedBudgetM = 1e-4;  ///< most that packing a clip may move a vertex

/// A skeleton with one clip, as an animation and compiled.
struct Character {
  std::string name;
  Skeleton skeleton;
  Animation animation;
  Clip clip;
  std::optional<Clip> packed;  ///< the clip within kPackedBudgetM; only for models and the biped

  Character(std::string named, Skeleton s, Animation a);
  std::size_t joint_count() const { return skeleton.joint_count(); }
};

/// Generated characters, those of the showcase, and those of the corpus if there is one. Models have at least sixteen
/// joints and give up to three clips each. All tracks are linear, because the plain GLM version samples no others.
const std::vector<std::shared_ptr<const Character>>& characters();

/// Skinned, animated files of the corpus whose clips the plain GLM version can play.
struct NamedScene {
  std::string name;
  std::shared_ptr<const Scene> scene;
};
const std::vector<NamedScene>& corpus_scenes();

}  // namespace sinew::bench
