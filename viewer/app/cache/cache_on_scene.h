// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/geometry_cache/bind_geometry.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "viewer/app/cache/cache_file.h"

namespace sinew::viewer {

/// A geometry cache bound to mesh instances of a scene.
struct CacheOnScene {
  CacheFile file;
  std::vector<GeometryBinding> bindings;  ///< validated by check()
  double start_s = 0.0;                   ///< cache time at scene time 0

  double duration_s() const noexcept;            ///< scene time at which the cache ends
  std::vector<std::uint32_t> instances() const;  ///< for Needs::in.cached_instances: sorted, no duplicates
  /// [instances] bounds over all frames; empty for instances without a cache.
  std::vector<Aabb> reach(const Scene& scene) const;
};

/// One sentence: why a frame cannot be shown.
/// in   status  damaged or not_loaded
std::string describe_fault(const CacheFile& file, GeometryStatus status);

/// Binds each mesh of a cache to the scene's mesh of the same name.
/// in   log_line  receives one line for each mesh that does not bind; may be empty
/// err  one sentence if no mesh binds
tl::expected<std::shared_ptr<const CacheOnScene>, std::string> bind_cache(
    CacheFile file, const Scene& scene, const std::function<void(const std::string&)>& log_line);

/// A cache shown without a glTF file: a scene made of the meshes of its first frame, and the cache bound to it.
struct CacheAlone {
  Scene scene;
  std::shared_ptr<const CacheOnScene> cache;
};

/// err  one sentence if the first frame cannot be read
tl::expected<CacheAlone, std::string> show_cache_alone(CacheFile file);

}  // namespace sinew::viewer
