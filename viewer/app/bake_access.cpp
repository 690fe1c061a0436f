// SPDX-License-Identifier: MIT
#include "viewer/app/bake_access.h"

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

bool has_values(const MeshAccess& access) {
  return std::any_of(access.begin(), access.end(), [](const auto& mesh) {
    return std::any_of(mesh.begin(), mesh.end(), [](const auto& values) { return !values.empty(); });
  });
}

/// The key poses, without values yet; one pose is the rest pose.
VertexAccess key_poses_of(const Exhibit& exhibit, const AccessBaking& baking) {
  const double duration = std::max(baking.clip == kNone ? 0.0 : exhibit.scene.animations[baking.clip].duration_s,
                                   cache_duration_s(exhibit));
  VertexAccess access;
  access.times_s = key_pose_times(duration, baking.key_poses);
  if (access.times_s.size() > 1) access.clip = baking.clip;
  return access;
}

}  // namespace

std::shared_ptr<const VertexAccess> access_of_file(const ImportedFile& file,
                                                   const std::function<void(const std::string&)>& say) {
  std::vector<ImportIssue> issues;
  VertexAccess access = read_ambient_access(file, issues);
  for (const ImportIssue& issue : issues)
    say(describe(file.facts.files.empty() ? "" : file.facts.files[0].string(), issue));
  if (!has_values(access.values)) return nullptr;
  return std::make_shared<const VertexAccess>(std::move(access));
}

tl::expected<void, std::string> add_missing_access(Exhibit& exhibit, const AccessBaking& baking,
                                                   const std::function<void(const std::string&)>& say,
                                                   const std::function<void(double)>& progress) {
  if (exhibit.access) return {};
  const auto start = std::chrono::steady_clock::now();
  VertexAccess access = key_poses_of(exhibit, baking);
  const AccessOptions how{.progress = progress};
  try {
    KeyPoseBaker baker(exhibit.scene, how, std::nullopt, access);
    for_each_pose(exhibit.scene, access.clip, exhibit.cache.get(), access.times_s,
                  [&](const FrameResult& pose) { baker.add(pose); });
  } catch (const std::runtime_error& error) {
    return tl::unexpected(std::string(error.what()));
  }
  char text[128];
  std::snprintf(text, sizeof text, "%zu %s, %u rays a vertex, baked in %.2f s", access.times_s.size(),
                access.times_s.size() == 1 ? "pose" : "key poses", how.rays,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  say(exhibit.name + ": ambient access of " + text);
  exhibit.access = std::make_shared<const VertexAccess>(std::move(access));
  return {};
}

#else

std::shared_ptr<const VertexAccess> access_of_file(const ImportedFile&,
                                                   const std::function<void(const std::string&)>&) {
  return nullptr;
}

tl::expected<void, std::string> add_missing_access(Exhibit&, const AccessBaking&,
                                                   const std::function<void(const std::string&)>&,
                                                   const std::function<void(double)>&) {
  return tl::unexpected(std::string("--ao rays: this program is built without Embree and casts no rays"));
}

#endif

}  // namespace sinew::viewer
