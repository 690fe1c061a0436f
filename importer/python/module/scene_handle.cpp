// SPDX-License-Identifier: MIT
#include "importer/python/module/scene_handle.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "importer/formats/import_format.h"
#include "importer/import_gltf.h"
#include "importer/platform/files.h"
#include "importer/python/module/errors.h"
#include "runtime/compress/compile_clip_within.h"
#include "runtime/retarget/hold_feet.h"
#include "runtime/retarget/map_scenes.h"
#include "runtime/retarget/retarget_animation.h"
#include "runtime/retarget/retarget_weights.h"
#include "runtime/retarget/share_twist.h"

namespace sinew::python {
namespace {

template <class T>
T value_or_throw(ImportResult<T> result) {
  if (!result) throw FileFailure(std::move(result.error()));
  return std::move(*result);
}

/// True if the file's name says that it is a format which import_format reads.
bool is_other_format(const std::filesystem::path& file) {
  std::string ending = platform::text_of(file.extension());
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".bvh" || ending == ".fbx" || ending == ".dae";
}

Clip compile(const Scene& scene, const Animation& keys) {
  return compile_clip(keys, scene.skeleton, rest_weights_of(scene), scene.first_weight, scene.properties);
}

std::shared_ptr<ClipHandle> make_clip(std::shared_ptr<const SceneHandle> owner, Animation keys) {
  Clip clip = compile(*owner->scene, keys);
  const std::size_t index = owner->scene->clips.size();
  return std::make_shared<ClipHandle>(
      ClipHandle{std::move(owner), std::move(clip), std::make_shared<const Animation>(std::move(keys)), index});
}

}  // namespace

std::shared_ptr<SceneHandle> load_scene(const std::filesystem::path& file, bool centers_of_rotation, bool images) {
  ImportOptions options;
  options.decode_images = images;
  options.make_centers_of_rotation = centers_of_rotation;
  ImportedFile imported = [&] {
    if (!is_other_format(file)) return value_or_throw(import_gltf(file, options));
    const formats::ImportedFormat converted = value_or_throw(formats::import_format(file));
    ImportedFile of_glb = value_or_throw(import_gltf(converted.glb, platform::text_of(file), options));
    of_glb.warnings.insert(of_glb.warnings.begin(), converted.warnings.begin(), converted.warnings.end());
    return of_glb;
  }();
  return std::make_shared<SceneHandle>(SceneHandle{share(std::move(imported.scene)), std::move(imported.warnings),
                                                   std::move(imported.vrm), platform::text_of(file)});
}

std::vector<ImportIssue> check_file(const std::filesystem::path& file) {
  ImportOptions options;
  options.thorough = options.collect_all_errors = true;
  options.decode_images = false;
  options.probe_images = true;
  auto imported = import_gltf(file, options);
  if (imported) return imported->warnings;
  std::vector<ImportIssue> issues{std::move(imported.error().issue)};
  for (auto* more : {&imported.error().more_errors, &imported.error().warnings})
    issues.insert(issues.end(), more->begin(), more->end());
  return issues;
}

std::vector<std::shared_ptr<ClipHandle>> clips_of(const std::shared_ptr<SceneHandle>& scene) {
  std::vector<std::shared_ptr<ClipHandle>> clips;
  for (std::size_t i = 0; i < scene->scene->clips.size(); ++i)
    clips.push_back(std::make_shared<ClipHandle>(
        ClipHandle{scene, scene->scene->clips[i],
                   std::shared_ptr<const Animation>(scene->scene, &scene->scene->animations[i]), i}));
  return clips;
}

std::shared_ptr<ClipHandle> compile_within(const ClipHandle& clip, double budget) {
  require(clip.keys != nullptr, "compile: the clip was compiled before; compile the one it was made from");
  const VirtualVertices vertices = virtual_vertices(clip.scene());
  ClipWithin within = compile_clip_within(clip.scene(), *clip.keys, vertices, budget);
  return std::make_shared<ClipHandle>(ClipHandle{clip.owner, std::move(within.clip), nullptr, clip.index});
}

RetargetedClip retarget_clip(const ClipHandle& clip, const std::shared_ptr<SceneHandle>& target, bool hold) {
  require(clip.keys != nullptr, "retarget: the clip has no keys any more; retarget the one that it was compiled from");
  const Scene &from = clip.scene(), &to = *target->scene;
  SkeletonMapOptions options;
  if (clip.owner->vrm) options.source_bones = humanoid_bones_of(clip.owner->vrm->bones);
  if (target->vrm) options.target_bones = humanoid_bones_of(target->vrm->bones);
  const SkeletonMap map = make_skeleton_map(from, to, options);
  require(!map.joints.empty(), "retarget: no joint of " + target->file + " is like one of " + clip.owner->file);
  const FeetMap feet = hold ? make_feet_map(map, from.skeleton, to.skeleton) : FeetMap{};
  require(!hold || !feet.legs.empty(),
          "retarget: no leg with thigh, shank and foot follows one of " + clip.owner->file);
  Animation keys = retarget_animation(*clip.keys, map, from.skeleton, to.skeleton);
  share_twist(make_twist_map(map, to.skeleton), keys);
  if (hold) hold_feet(feet, *clip.keys, from.skeleton, to.skeleton, keys);
  retarget_weights(make_weight_map(from, to), *clip.keys, from, to, keys);
  RetargetedClip out{make_clip(target, std::move(keys)), {}, map.height_ratio};
  for (const std::uint32_t joint : map.unmapped_target) out.resting.push_back(to.skeleton.names[joint]);
  return out;
}

}  // namespace sinew::python
