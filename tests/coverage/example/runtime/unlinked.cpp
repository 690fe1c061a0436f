// SPDX-License-Identifier: MIT
int unlinked(int x) {
  x += 1;
  return x;
}
