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

/// A geometry cache and the mesh instances of a scene that it plays in.
struct CacheOnScene {
  CacheFile file;
  std::vector<GeometryBinding> bindings;  ///< have passed check()
  double start_s = 0.0;                   ///< on the clock of the cache, when the scene's clock is 0

  double duration_s() const noexcept;                 ///< on the scene's clock
  std::vector<std::uint32_t> instances() const;       ///< as Needs::cached_instances
  std::vector<Aabb> reach(const Scene& scene) const;  ///< [instances] box of all frames; empty where none plays
};

/// Why a frame cannot be shown, in one sentence.
/// in   status  damaged or not_loaded
std::string describe_fault(const CacheFile& file, GeometryStatus status);

/// Binds a cache to the meshes of the same names.
/// in   say  receives what does not bind, a line each; may be empty
/// err  one sentence, when nothing binds
tl::expected<std::shared_ptr<const CacheOnScene>, std::string> bind_cache(
    CacheFile file, const Scene& scene, const std::function<void(const std::string&)>& say);

/// A cache alone: a scene with its meshes as in the first frame, and the cache on it.
struct CacheAlone {
  Scene scene;
  std::shared_ptr<const CacheOnScene> cache;
};

/// err  one sentence, when the first frame cannot be read
tl::expected<CacheAlone, std::string> show_cache_alone(CacheFile file);

}  // namespace sinew::viewer
