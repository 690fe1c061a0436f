// SPDX-License-Identifier: MIT
#include "runtime/model/mirror_scene.h"

#include "runtime/animation/side_names.h"

namespace sinew {

MirrorMap make_mirror_map(const Scene& scene, const MirrorOptions& options) {
  MirrorMap map = make_mirror_map(scene.skeleton, options);
  bool moves = false;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const std::vector<std::string>& names = scene.meshes[scene.instances[i].mesh].target_names;
    const std::uint32_t first = scene.first_weight[i], count = scene.first_weight[i + 1] - first;
    std::vector<std::uint32_t> partners = name_partners(names);
    for (std::uint32_t t = 0; t < count; ++t) {
      const std::uint32_t from = names.size() == count ? partners[t] : t;
      map.weight_source.push_back(first + from);
      moves |= from != t;
    }
  }
  if (!moves) map.weight_source.clear();
  return map;
}

}  // namespace sinew
