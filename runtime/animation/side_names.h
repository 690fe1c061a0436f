// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/api.h"

namespace sinew {

/// The side of a body.
enum class Side : std::uint8_t { none, left, right };

/// The side that the name of a joint, morph target or event tells. The mark of a side is one of these, in any case:
///     `left` or `right` at an end of a word   LeftArm, mixamorig:LeftArm, eyeBlinkLeft, left_foot_down
///     L or R between separators               upperarm.l, Ear_L, J_Bip_L_Hand, Bip01 L Thigh, l_arm
///     L or R before a capital letter          lShldr, LArm
///     capital L or R at the end of a word     HandL
SINEW_API Side side_of(std::string_view name);

/// Candidates for the name of the same thing on the other side, best first. In each of them one mark of a side is
/// exchanged. Empty if `name` tells no side.
SINEW_API std::vector<std::string> other_sides(std::string_view name);

/// For each name the index of its partner on the other side, or its own index if it has none. Partners are mutual, and
/// names that occur twice have none. Numbers that exporters append may differ if the names are unique without them
/// (LeftArm_09, RightArm_06). For events: when a mirrored clip crosses event i, fire event `partner[i]`.
/// out  [names]     cost O(N log N), allocates
SINEW_API std::vector<std::uint32_t> name_partners(std::span<const std::string> names);

}  // namespace sinew
