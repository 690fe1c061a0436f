// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// What a name says about the side of a body.
enum class Side : std::uint8_t { none, left, right };

/// Side of a joint, morph target or event by its name: a word `left` or `right` at the start or end of a word, in any
/// case (LeftArm, mixamorig:LeftArm, eyeBlinkLeft, left_foot_down), or a letter L or R that stands alone between
/// separators (upperarm.l, Ear_L, J_Bip_L_Hand, Bip01 L Thigh, l_arm), before a capital (lShldr, LArm) or after a small
/// letter at the end of a word (HandL).
Side side_of(std::string_view name);

/// The names that stand for the other side of `name`, best first: one place of it is turned in each. Empty without one.
std::vector<std::string> other_sides(std::string_view name);

/// For each name the index of its partner on the other side, its own index where there is none. A number at the end of
/// both, as exporters append, may differ where the rest is unique (LeftArm_09, RightArm_06). Names that repeat have no
/// partner. Two names are always partners of each other. For events: fire event `partner[i]` where a mirrored clip
/// crosses event i.
/// out  [names]     cost O(N log N), allocates
std::vector<std::uint32_t> name_partners(std::span<const std::string> names);

}  // namespace sinew
