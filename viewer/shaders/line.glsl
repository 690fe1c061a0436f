// SPDX-License-Identifier: MIT
const float kLineHalfWidth = 0.75;                  // pixels
const float kLineReach = kLineHalfWidth + 0.5;      // beyond this distance, pixels are not covered
