// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/vrm.h"

namespace sinew::viewer {

/// Angle about +y from +z to the side that the character faces. VRM 0 faces -z, VRM 1 faces +z as glTF models do.
double facing_yaw_rad(const VrmCharacter& vrm);

/// The meta data in one sentence: version, name, authors and licence. Empty parts are left out.
std::string describe_meta(const VrmCharacter& vrm);

}  // namespace sinew::viewer
