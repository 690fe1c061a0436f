// SPDX-License-Identifier: MIT
#include "runtime/retarget/retarget_properties.h"

#include <optional>

#include "runtime/library/clip_channels.h"

namespace sinew {
namespace {

std::size_t thing_count(const Scene& scene, PropertyKind kind) noexcept {
  if (kind <= PropertyKind::camera_far) return scene.cameras.size();
  return kind <= PropertyKind::light_outer_cone ? scene.lights.size() : scene.materials.size();
}

/// The same property on the target; empty if it does not exist or the name is ambiguous.
std::optional<PropertyTarget> same_property(const PropertyTarget& from, const SkeletonMap& map, const Scene& source,
                                            const Scene& target) {
  PropertyTarget to = from;
  if (from.kind == PropertyKind::node_visible) {
    for (const MappedJoint& joint : map.joints)
      if (joint.source == from.index) {
        to.index = joint.target;
        return to;
      }
    return std::nullopt;
  }
  const std::string name = property_name(source, from);
  std::optional<PropertyTarget> found;
  for (to.index = 0; !name.empty() && to.index < thing_count(target, from.kind); ++to.index) {
    if (property_name(target, to) != name) continue;
    if (found) return std::nullopt;
    found = to;
  }
  return found;
}

}  // namespace

std::vector<std::string> retarget_properties(const Animation& animation, const SkeletonMap& map, const Scene& source,
                                             const Scene& target, Animation& retargeted) {
  std::vector<std::string> left_out;
  retargeted.properties.clear();
  for (const PropertyTrack& track : animation.properties) {
    if (const auto to = same_property(track.target, map, source, target)) {
      retargeted.properties.push_back({*to, track.values});
      continue;
    }
    const std::string name = property_name(source, track.target);
    left_out.push_back(name.empty() ? "a property of a thing without a name" : name);
  }
  return left_out;
}

}  // namespace sinew
