// SPDX-License-Identifier: MIT
// Bakes the flag of the showcase: sinew-bake-flag OUT. Writes the bytes of a geometry cache as an initialiser in C++.
#include <cstdio>
#include <fstream>
#include <utility>

#include "importer/geometry_cache/encode_geometry_cache.h"
#include "samples/showcase/flag_cloth.h"
#include "samples/showcase/showcase.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: sinew-bake-flag OUT\n");
    return 2;
  }
  sinew::showcase::ClothFrames flight = sinew::showcase::flag_flight();
  sinew::GeometryTake take;
  sinew::TakeMesh& mesh = take.meshes.emplace_back();
  mesh.name = sinew::showcase::kFlagMesh;
  mesh.vertex_count = flight.columns * flight.rows;
  mesh.triangles = std::move(flight.triangles);
  mesh.streams.push_back({sinew::GeometryKind::positions, std::move(flight.frames), sinew::showcase::kFlagBudget_m});
  const auto cache = sinew::encode_geometry_cache(take);
  if (!cache) {
    std::fprintf(stderr, "sinew-bake-flag: %s\n", sinew::describe("flag", cache.error().issue).c_str());
    return 1;
  }
  std::ofstream out(argv[1]);
  for (std::size_t i = 0; i < cache->size(); ++i)
    out << std::to_integer<int>((*cache)[i]) << (i % 32 == 31 ? ",\n" : ",");
  out.close();
  if (out) return 0;
  std::fprintf(stderr, "sinew-bake-flag: %s cannot be written\n", argv[1]);
  return 1;
}
