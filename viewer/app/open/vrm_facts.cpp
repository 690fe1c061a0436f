// SPDX-License-Identifier: MIT
#include "viewer/app/open/vrm_facts.h"

#include <numbers>

namespace sinew::viewer {

double facing_yaw_rad(const VrmCharacter& vrm) {
  return !vrm.is_animation && vrm.version.starts_with('0') ? std::numbers::pi : 0.0;
}

std::string describe_meta(const VrmCharacter& vrm) {
  std::string text = "VRM " + vrm.version;
  if (!vrm.name.empty()) text += ": \"" + vrm.name + '"';
  if (!vrm.authors.empty()) text += " by " + vrm.authors;
  if (!vrm.licence.empty()) text += ", licence " + vrm.licence;
  return text;
}

}  // namespace sinew::viewer
