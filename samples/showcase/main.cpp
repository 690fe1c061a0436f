// SPDX-License-Identifier: MIT
// Writes the showcase scenes as .glb files: sinew-showcase DIR
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "importer/export_glb.h"
#include "samples/showcase/showcase.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: sinew-showcase DIR      writes the built-in scenes as DIR/*.glb\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  for (const auto& scene : sinew::showcase::showcase()) {
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
  }
}
