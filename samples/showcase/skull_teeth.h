// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/mesh.h"

namespace sinew::showcase {

/// The 28 teeth of a skull without wisdom teeth, where skull_bones.h has their rows. Roots are in the bone.
Primitive skull_teeth();

}  // namespace sinew::showcase
