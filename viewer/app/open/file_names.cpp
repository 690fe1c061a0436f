// SPDX-License-Identifier: MIT
#include "viewer/app/open/file_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 8> kEndings = {".gltf",  ".glb",  ".vrm", ".vrma",
                                                      ".sinew", ".sgeo", ".hdr", ".exr"};

}  // namespace

std::string ending_of(const std::string& file) {
  std::string ending = fs::path(file).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

bool names_panorama(const std::string& file) {
  const std::string ending = ending_of(file);
  return ending == ".hdr" || ending == ".exr";
}

std::vector<std::string> expand_folders(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      files.push_back(path);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(path, error))
      if (entry.is_regular_file(error) &&
          std::find(kEndings.begin(), kEndings.end(), ending_of(entry.path().string())) != kEndings.end())
        found.push_back(entry.path().string());
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

}  // namespace sinew::viewer
