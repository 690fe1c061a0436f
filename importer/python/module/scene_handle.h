// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "importer/import_error.h"
#include "importer/vrm.h"
#include "runtime/animation/bone_animation.h"
#include "runtime/clip/clip.h"
#include "runtime/model/scene.h"

namespace sinew::python {

/// The assets of one file. Clips keep it alive, and so do arrays that are views of it.
struct SceneHandle {
  std::shared_ptr<const Scene> scene;
  std::vector<ImportIssue> warnings;
  std::shared_ptr<const VrmCharacter> vrm;
  std::string file;
};

/// A clip together with the scene whose skeleton it moves.
struct ClipHandle {
  std::shared_ptr<const SceneHandle> owner;
  Clip clip;
  std::shared_ptr<const Animation> keys;  ///< authoring form; null for a clip that was compiled within a budget
  std::size_t index = 0;                  ///< in the file; clips that were made in Python count on from its last

  const Scene& scene() const noexcept { return *owner->scene; }
};

/// Reads a glTF, BVH, FBX or COLLADA file.
/// err   FileFailure: the file cannot be read
std::shared_ptr<SceneHandle> load_scene(const std::filesystem::path& file, bool centers_of_rotation, bool images);

/// Everything that is wrong or unusual about a glTF file, errors first. A file that cannot be read gives its errors.
std::vector<ImportIssue> check_file(const std::filesystem::path& file);

/// The clips of a scene in the order of its file.
std::vector<std::shared_ptr<ClipHandle>> clips_of(const std::shared_ptr<SceneHandle>& scene);

/// A clip within an error budget in the file's unit.
std::shared_ptr<ClipHandle> compile_within(const ClipHandle& clip, double budget);

/// A clip of one body for another. See make_skeleton_map.
struct RetargetedClip {
  std::shared_ptr<ClipHandle> clip;
  std::vector<std::string> resting;  ///< names of the target's joints that follow no joint
  double height_ratio = 1.0;
};
RetargetedClip retarget_clip(const ClipHandle& clip, const std::shared_ptr<SceneHandle>& target, bool hold_feet);

}  // namespace sinew::python
