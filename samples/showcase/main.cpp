// SPDX-License-Identifier: MIT
// Writes the showcase scenes as .glb files, and the geometry cache of the flag beside its scene: sinew-showcase DIR
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "importer/export_glb.h"
#include "samples/showcase/showcase.h"

namespace {

bool write(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.close();
  return static_cast<bool>(out);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr,
                 "usage: sinew-showcase DIR      writes the built-in scenes as DIR/*.glb and their geometry caches as "
                 "DIR/*.sgeo\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  for (const auto& scene : sinew::showcase::showcase(sinew::showcase::flag_cache())) {
    std::string name = scene.name + ".glb";
    for (char& c : name)
      if (c == ' ') c = '-';
    const auto written = sinew::export_glb(scene.scene, folder / name);
    if (!written) {
      std::fprintf(stderr, "sinew-showcase: %s\n",
                   sinew::describe((folder / name).string(), written.error().issue).c_str());
      return 1;
    }
    std::printf("%s  %zu bytes  %s\n", (folder / name).c_str(), *written, scene.what_to_look_at.c_str());
    if (scene.geometry_cache.empty()) continue;
    const std::filesystem::path cache = (folder / name).replace_extension(".sgeo");
    if (!write(cache, scene.geometry_cache)) {
      std::fprintf(stderr, "sinew-showcase: %s cannot be written\n", cache.c_str());
      return 1;
    }
    std::printf("%s  %zu bytes\n", cache.c_str(), scene.geometry_cache.size());
  }
}
