// SPDX-License-Identifier: MIT
#include "viewer/app/open/add_clips.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "importer/vrm.h"
#include "runtime/animation/skeleton_signature.h"
#include "runtime/retarget/map_scenes.h"
#include "runtime/retarget/retarget_animation.h"
#include "runtime/retarget/retarget_properties.h"
#include "runtime/retarget/retarget_weights.h"
#include "runtime/retarget/share_twist.h"

namespace sinew::viewer {
namespace {

constexpr std::size_t kMostNamesListed = 8;

std::string list(const std::set<std::string>& names) {
  std::string text;
  std::size_t listed = 0;
  for (const std::string& name : names) {
    if (listed++ == kMostNamesListed) return text + " and " + std::to_string(names.size() - kMostNamesListed) + " more";
    text += (text.empty() ? "\"" : ", \"") + name + '"';
  }
  return text;
}

std::vector<std::uint32_t> bones_of(const LoadedScene& loaded) {
  return loaded.vrm ? humanoid_bones_of(loaded.vrm->bones) : std::vector<std::uint32_t>();
}

SkeletonMap map_of(const LoadedScene& clips, const LoadedScene& character) {
  SkeletonMapOptions options;
  options.source_bones = bones_of(clips);
  options.target_bones = bones_of(character);
  return make_skeleton_map(clips.scene, character.scene, options);
}

/// Names of the joints that some clip moves and that no joint of the character follows.
std::set<std::string> unbound_joints(const SkeletonMap& map, const Scene& clips) {
  std::set<std::string> names;
  for (const Animation& animation : clips.animations)
    for (const BoneAnimation& bone : animation.bones)
      if (std::binary_search(map.unmapped_source.begin(), map.unmapped_source.end(), bone.joint))
        names.insert(clips.skeleton.names[bone.joint]);
  return names;
}

/// Names of the morph targets that the character lacks, if a clip moves morph targets at all.
std::set<std::string> unbound_targets(const WeightMap& map, const Scene& clips) {
  const bool any = std::any_of(clips.animations.begin(), clips.animations.end(),
                               [](const Animation& a) { return !a.weights.empty(); });
  return any ? std::set<std::string>(map.not_found.begin(), map.not_found.end()) : std::set<std::string>();
}

/// Compiles the new clips. Clips that were compiled within a budget (.sinew) stay as they are, unless the new ones
/// animate properties that the scene did not have.
void finish_with_new_clips(Scene& scene) {
  const std::vector<Clip> own = std::move(scene.clips);
  const std::size_t properties = scene.properties.entries.size();
  finish_scene(scene);
  if (scene.properties.entries.size() == properties) std::copy(own.begin(), own.end(), scene.clips.begin());
}

}  // namespace

bool is_clip_file(const Scene& scene) noexcept { return scene.instances.empty() && !scene.animations.empty(); }

void add_clips(const LoadedScene& clips, LoadedScene& character,
               const std::function<void(const std::string&)>& log_line) {
  const SkeletonMap map = map_of(clips, character);
  const WeightMap weights = make_weight_map(clips.scene, character.scene);
  const bool follows = std::any_of(weights.source_of.begin(), weights.source_of.end(),
                                   [](std::uint32_t source) { return source != kNone; });
  if (map.joints.empty() && !follows)
    return log_line(clips.name + ": warning: no joint is like one of " + character.name + "; its clips are left out");
  const TwistMap twists = make_twist_map(map, character.scene.skeleton);
  std::set<std::string> unbound = unbound_joints(map, clips.scene);
  unbound.merge(unbound_targets(weights, clips.scene));
  for (const Animation& animation : clips.scene.animations) {
    Animation added = retarget_animation(animation, map, clips.scene.skeleton, character.scene.skeleton);
    share_twist(twists, added);
    retarget_weights(weights, animation, clips.scene, character.scene, added);
    for (std::string& name : retarget_properties(animation, map, clips.scene, character.scene, added))
      unbound.insert(std::move(name));
    added.annotations = animation.annotations;
    character.scene.animations.push_back(std::move(added));
  }
  finish_with_new_clips(character.scene);
  character.files.insert(character.files.end(), clips.files.begin(), clips.files.end());
  if (!unbound.empty()) log_line(clips.name + ": warning: " + character.name + " has no " + list(unbound));
}

}  // namespace sinew::viewer
