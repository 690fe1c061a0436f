// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "importer/tool/cost/skinned_part.h"

namespace sinew::cost {

/// A round limb with two joints, one after the other along +Y: four metres long, half a metre in radius, with weights
/// that blend linearly over the middle. The surface is closed, so it has a volume.
struct Limb {
  Primitive primitive;
  Skin skin;
  Skeleton skeleton;
  PosedSkin bent;     ///< the second joint rotated by 90 degrees about x
  PosedSkin twisted;  ///< ... by 150 degrees about y: near the worst collapse, but short of a half turn, whose
                      ///< direction is ambiguous

  Limb();
};

/// The limb as a part to skin, for files without skinned vertices. The limb must outlive the part.
SkinnedPart part_of(const Limb& limb);

/// The volume that a closed surface encloses.
/// eq   sum over triangles of a . (b x c) / 6
double volume_of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

}  // namespace sinew::cost
