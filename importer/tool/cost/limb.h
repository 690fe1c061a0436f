// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "importer/tool/cost/skinned_part.h"

namespace sinew::cost {

/// A round limb of two joints, one after the other along +Y: four metres long, half a metre thick, weights linear over
/// the middle. Closed, so that it has a volume.
struct Limb {
  Primitive primitive;
  Skin skin;
  Skeleton skeleton;
  PosedSkin bent;     ///< the second joint by 90 degrees about x
  PosedSkin twisted;  ///< ... by 150 degrees about y: what is left of it when the collapse is bad, but no half turn,
                      ///< which has two ways round

  Limb();
};

/// The limb as a part to skin, for files that have none. It must outlive the part.
SkinnedPart part_of(const Limb& limb);

/// eq   sum over triangles of a . (b x c) / 6
double volume_of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

}  // namespace sinew::cost
