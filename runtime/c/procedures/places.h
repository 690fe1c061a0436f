// SPDX-License-Identifier: MIT
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

// Places and matrices in double, far from the origin too. These structs never grow.

typedef struct sinew_point {
  double x, y, z;
} sinew_point;  ///< a place or direction
typedef struct sinew_affine_double {
  double row[3][4];
} sinew_affine_double;  ///< as sinew_affine

#ifdef __cplusplus
}
#endif
