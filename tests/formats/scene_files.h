// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace sinew::test {

/// An FBX file as text, in inches with z up: "hip" with every part of a joint's transform, and "knee" below it with a
/// rotation before its own. Within 1 s the hip turns about x from 10 to 40 and -20 degrees, and the knee moves in y
/// from 10 to 12.
std::string pivots_fbx();

/// An FBX file as text, in centimetres: "boat" at (0, 100, 0) with "flag" at (0, 50, 0) below it; both show the mesh
/// "sail", a square of 100. At the boat it is turned by 90 degrees about y and moved by 10 in z, which the flag must
/// not be. Its target "wind" moves the corners 2 and 3 by 50 and 25 in z. Within 1 s its weight goes from 0 to 100 %
/// and 25 %.
std::string sail_fbx();

/// A COLLADA file in feet with z up: the node "tower" at (0, 0, 3) with one triangle.
std::string tower_collada();

}  // namespace sinew::test
