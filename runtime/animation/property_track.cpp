// SPDX-License-Identifier: MIT
#include "runtime/animation/property_track.h"

#include <algorithm>

namespace sinew {

std::uint32_t component_count(PropertyKind kind) noexcept {
  switch (kind) {
    case PropertyKind::base_color: return 4;
    case PropertyKind::light_color:
    case PropertyKind::emissive: return 3;
    case PropertyKind::texture_offset:
    case PropertyKind::texture_scale: return 2;
    default: return 1;
  }
}

const PropertyTable::Entry* PropertyTable::find(const PropertyTarget& target) const noexcept {
  const auto found = std::lower_bound(entries.begin(), entries.end(), target,
                                      [](const Entry& entry, const PropertyTarget& t) { return entry.target < t; });
  return found != entries.end() && found->target == target ? &*found : nullptr;
}

}  // namespace sinew
