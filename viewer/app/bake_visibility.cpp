// SPDX-License-Identifier: MIT
#include "viewer/app/bake_visibility.h"

#include <memory>

#ifdef SINEW_WITH_RAYS
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "importer/ambient/ambient_attribute.h"
#include "importer/ambient/bake_key_poses.h"
#include "viewer/app/clip_poses.h"
#endif

namespace sinew::viewer {

#ifdef SINEW_WITH_RAYS

namespace {

bool has_values(const MeshVisibility& visibility) {
  return std::any_of(visibility.begin(), visibility.end(), [](const auto& mesh) {
    return std::any_of(mesh.begin(), mesh.end(), [](const auto& values) { return !values.empty(); });
  });
}

/// Clip and times of the poses to bake, with no values yet. With a single key pose this is the rest pose.
VertexVisibility key_poses_of(const LoadedScene& loaded, const VisibilityBaking& baking) {
  const double duration =
      std::max(baking.clip == kNone ? 0.0 : loaded.scene.animations[baking.clip].duration_s, cache_duration_s(loaded));
  VertexVisibility visibility;
  visibility.times_s = key_pose_times(duration, baking.key_poses);
  if (visibility.times_s.size() > 1) visibility.clip = baking.clip;
  return visibility;
}

}  // namespace

std::shared_ptr<const VertexVisibility> file_visibility(const ImportedFile& file,
                                                        const std::function<void(const std::string&)>& log_line) {
  std::vector<ImportIssue> issues;
  VertexVisibility visibility = read_ambient_visibility(file, issues);
  for (const ImportIssue& issue : issues)
    log_line(describe(file.facts.files.empty() ? "" : file.facts.files[0].string(), issue));
  if (!has_values(visibility.values)) return nullptr;
  return std::make_shared<const VertexVisibility>(std::move(visibility));
}

tl::expected<void, std::string> bake_missing_visibility(LoadedScene& loaded, const VisibilityBaking& baking,
                                                        const std::function<void(const std::string&)>& log_line,
                                                        const std::function<void(double)>& progress) {
  if (loaded.visibility) return {};
  const auto start = std::chrono::steady_clock::now();
  VertexVisibility visibility = key_poses_of(loaded, baking);
  const VisibilityOptions options{.progress = progress};
  try {
    KeyPoseBaker baker(loaded.scene, options, std::nullopt, visibility);
    for_each_pose(loaded.scene, visibility.clip, loaded.cache.get(), visibility.times_s,
                  [&](const FrameResult& pose) { baker.add(pose); });
  } catch (const std::runtime_error& error) {
    return tl::unexpected(std::string(error.what()));
  }
  char text[128];
  std::snprintf(text, sizeof text, "%zu %s, %u rays a vertex, baked in %.2f s", visibility.times_s.size(),
                visibility.times_s.size() == 1 ? "pose" : "key poses", options.rays,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  log_line(loaded.name + ": ambient visibility of " + text);
  loaded.visibility = std::make_shared<const VertexVisibility>(std::move(visibility));
  return {};
}

#else

std::shared_ptr<const VertexVisibility> file_visibility(const ImportedFile&,
                                                        const std::function<void(const std::string&)>&) {
  return nullptr;
}

tl::expected<void, std::string> bake_missing_visibility(LoadedScene&, const VisibilityBaking&,
                                                        const std::function<void(const std::string&)>&,
                                                        const std::function<void(double)>&) {
  return tl::unexpected(std::string("--ao rays: this program is built without Embree and casts no rays"));
}

#endif

}  // namespace sinew::viewer
