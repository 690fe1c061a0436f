// SPDX-License-Identifier: MIT
#include "viewer/app/cache/cache_on_scene.h"

#include <algorithm>
#include <utility>

#include "runtime/geometry_cache/scene_of_cache.h"
#include "viewer/app/cache/cache_reader.h"

namespace sinew::viewer {

double CacheOnScene::duration_s() const noexcept {
  return std::max(0.0, file.cache.start_s() + file.cache.duration_s() - start_s);
}

std::vector<std::uint32_t> CacheOnScene::instances() const {
  std::vector<std::uint32_t> all;
  for (const GeometryBinding& binding : bindings) all.push_back(binding.instance);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<Aabb> CacheOnScene::reach(const Scene& scene) const {
  std::vector<Aabb> boxes(scene.instances.size());
  for (const GeometryBinding& binding : bindings) {
    const Aabb& box = file.cache.meshes()[binding.mesh].bounds;
    boxes[binding.instance].add(box.lower);
    boxes[binding.instance].add(box.upper);
  }
  return boxes;
}

std::string describe_fault(const CacheFile& file, GeometryStatus status) {
  if (status == GeometryStatus::not_loaded)
    return file.name + ": cache-size: a frame cannot be read: the file has changed";
  return file.name + ": cache-checksum: a frame is not as it was written; bake the cache again";
}

tl::expected<std::shared_ptr<const CacheOnScene>, std::string> bind_cache(
    CacheFile file, const Scene& scene, const std::function<void(const std::string&)>& log_line) {
  GeometryBindings found = bind_by_name(file.cache, scene);
  for (const std::string& unbound : found.unbound)
    if (log_line) log_line(file.name + ": warning: " + unbound);
  if (found.bound.empty()) return tl::unexpected(file.name + ": no mesh of the scene fits one of the cache");
  // If the scene has clips, clip time and cache time are the same, because `sinew bake` samples at clip times.
  const double start_s = scene.animations.empty() ? file.cache.start_s() : 0.0;
  return std::make_shared<const CacheOnScene>(CacheOnScene{std::move(file), std::move(found.bound), start_s});
}

tl::expected<CacheAlone, std::string> show_cache_alone(CacheFile file) {
  CacheReader reader(file, CacheReader::Reads::blocking, 1);
  FrameWindow window(file.cache, reader.reader(), 1);
  auto made = scene_of(file.cache, window);
  if (!made) return tl::unexpected(describe_fault(file, made.error()));
  const double start_s = file.cache.start_s();
  CacheAlone out;
  out.scene = std::move(made->scene);
  out.cache = std::make_shared<const CacheOnScene>(CacheOnScene{std::move(file), std::move(made->bindings), start_s});
  return out;
}

}  // namespace sinew::viewer
