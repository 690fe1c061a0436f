// SPDX-License-Identifier: MIT
// sinew-fuzz-seeds OUT [FOLDER...]: writes OUT/TARGET/NUMBER for every target. Seeds come from code, and from the glTF
// files, images and poses below the folders.
#include <cstdio>
#include <fstream>
#include <set>

#include "tests/fuzz/seeds.h"

namespace {

namespace fs = std::filesystem;

bool usable(const fs::directory_entry& entry) {
  static const std::set<std::string> kExtensions{".glb", ".gltf", ".png", ".jpg", ".webp", ".avif", ".json"};
  return entry.is_regular_file() && kExtensions.contains(entry.path().extension().string()) &&
         !entry.path().filename().string().ends_with(".report.json");
}

std::size_t write(const std::vector<sinew::fuzz::Seed>& seeds, const fs::path& out, std::size_t number) {
  for (const auto& seed : seeds) {
    fs::create_directories(out / seed.target);
    std::ofstream file(out / seed.target / std::to_string(number++), std::ios::binary);
    file.write(reinterpret_cast<const char*>(seed.bytes.data()), static_cast<std::streamsize>(seed.bytes.size()));
  }
  return number;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: sinew-fuzz-seeds OUT [FOLDER...]\n");
    return 2;
  }
  std::size_t count = write(sinew::fuzz::own_seeds(), argv[1], 0);
  for (int i = 2; i < argc; ++i)
    if (fs::is_directory(argv[i]))
      for (const auto& entry : fs::recursive_directory_iterator(argv[i]))
        if (usable(entry)) count = write(sinew::fuzz::seeds_of_file(entry.path()), argv[1], count);
  std::printf("%zu seeds\n", count);
  return 0;
}
