// SPDX-License-Identifier: MIT
// Where float ends: the largest error of each kernel over a sweep of inputs, against double precision. Errors are in
// radians, metres or seconds, and in steps of float. Common shortcuts are measured too, to show their errors.
#include <cstdio>
#include <cstring>

#include "samples/where_float_ends/rows.h"

int main(int argc, char** argv) {
  using namespace sinew::sample;
  Rows rows;
  add_rotation_rows(rows);
  add_pose_rows(rows);
  add_vertex_rows(rows);

  const auto wanted = [&](const Row& row) { return argc < 2 || row.part == argv[1]; };
  bool found = false;
  for (const Row& row : rows) found = found || wanted(row);
  if (argc > 2 || !found) {
    std::fprintf(stderr, "usage: %s [rotations|poses|vertices]\n", argv[0]);
    return 2;
  }

  std::printf("%-38s %-36s %10s %-4s %9s %9s\n", "in float", "over", "error", "", "ulp", "bound");
  int beyond = 0;
  const char* part = "";
  for (const Row& row : rows) {
    if (!wanted(row)) continue;
    if (row.part != part) std::printf("\n%s\n", part = row.part.c_str());
    const bool holds = row.error <= row.bound;
    beyond += !holds;
    std::printf("%-38s %-36s %10.2g %-4s %9.2g %9.2g%s\n", row.kernel.c_str(), row.sweep.c_str(), row.error, row.unit,
                row.ulp, row.bound, holds ? "" : "  BEYOND");
  }
  return beyond == 0 ? 0 : 1;
}
