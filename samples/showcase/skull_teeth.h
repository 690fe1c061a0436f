// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/mesh.h"

namespace sinew::showcase {

/// The 28 teeth of a skull without wisdom teeth, on the rows of skull_bones.h. Their roots are inside the bone.
Primitive skull_teeth();

}  // namespace sinew::showcase
