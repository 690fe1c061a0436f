// SPDX-License-Identifier: MIT
#pragma once
#include <utility>

#include "tests/viewer/cache_files.h"
#include "viewer/app/loaded_scene.h"

namespace sinew::viewer {

/// A square of 1 m that glides 4 m along x in 20 frames of a geometry cache.
inline Bytes gliding_cache() {
  std::vector<std::vector<glm::vec3>> frames;
  for (int frame = 0; frame < 20; ++frame) {
    const float x = 4.0f * static_cast<float>(frame) / 19.0f;
    frames.push_back({{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0}});
  }
  return *encode_geometry_cache(test::take_of(std::move(frames), {0, 1, 2, 0, 2, 3}), {.segment_frames = 8});
}

/// A geometry cache as the viewer loads it without a glTF file.
inline LoadedScene scene_of_cache_file(const Bytes& bytes) {
  CacheAlone alone = flag_alone(bytes);
  LoadedScene loaded;
  loaded.scene = std::move(alone.scene);
  loaded.cache = std::move(alone.cache);
  return loaded;
}

}  // namespace sinew::viewer
