// SPDX-License-Identifier: MIT
#pragma once
#include <utility>

#include "tests/viewer/cache_files.h"
#include "viewer/app/exhibit.h"

namespace sinew::viewer {

/// A geometry cache without a scene, as it is shown.
inline Exhibit exhibit_of_cache(const Bytes& bytes) {
  CacheAlone alone = flag_alone(bytes);
  Exhibit exhibit;
  exhibit.scene = std::move(alone.scene);
  exhibit.cache = std::move(alone.cache);
  return exhibit;
}

}  // namespace sinew::viewer
