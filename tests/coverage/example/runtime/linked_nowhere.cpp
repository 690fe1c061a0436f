// SPDX-License-Identifier: MIT
int linked_nowhere(int x) {
  x += 1;
  return x;
}
