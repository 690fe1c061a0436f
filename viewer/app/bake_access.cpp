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

/// The times of the key poses; one pose has no clip.
VertexAccess without_values(const Exhibit& exhibit, const AccessBaking& baking) {
  VertexAccess access;
  const double duration = std::max(baking.clip == kNone ? 0.0 : exhibit.scene.animations[baking.clip].duration_s,
                                   cache_duration_s(exhibit));
  if (baking.key_poses < 2 || !(duration > 0.0)) return access;
  access.clip = baking.clip;
  access.times_s.clear();
  for (std::uint32_t i = 0; i < baking.key_poses; ++i)
    access.times_s.push_back(duration * i / (baking.key_poses - 1.0));
  return access;
}

/// Appends the values of one more pose. A primitive that a pose does not show is open in it.
void append(const Scene& scene, const MeshAccess& pose, VertexAccess& access) {
  access.values.resize(scene.meshes.size());
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    access.values[m].resize(scene.meshes[m].primitives.size());
    for (std::size_t p = 0; p < access.values[m].size(); ++p) {
      std::vector<float>& all = access.values[m][p];
      const std::vector<float>& more = pose[m][p];
      if (more.empty())
        all.resize(all.size() + scene.meshes[m].primitives[p].vertex_count(), 1.0f);
      else
        all.insert(all.end(), more.begin(), more.end());
    }
  }
}

void bake_poses(const Exhibit& exhibit, const std::function<void(double)>& progress, AccessOptions how,
                VertexAccess& access) {
  std::size_t done = 0;
  const auto count = static_cast<double>(access.times_s.size());
  if (progress) how.progress = [&](double part) { progress((static_cast<double>(done) + part) / count); };
  for_each_pose(exhibit.scene, access.clip, exhibit.cache.get(), access.times_s, [&](const FrameResult& pose) {
    if (done == 0) how.distance_m = default_access_distance_m(exhibit.scene, pose);
    append(exhibit.scene, bake_mesh_access(exhibit.scene, pose, how), access);
    ++done;
  });
}

}  // namespace

std::shared_ptr<const VertexAccess> access_of_file(const ImportedFile& file,
                                                   const std::function<void(const std::string&)>& say) {
  std::vector<ImportIssue> issues;
  VertexAccess access;
  access.values = read_ambient_access(file, issues);
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
  VertexAccess access = without_values(exhibit, baking);
  const AccessOptions how;
  try {
    bake_poses(exhibit, progress, how, access);
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
