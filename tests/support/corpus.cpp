// SPDX-License-Identifier: MIT
#include "tests/support/corpus.h"

#include <algorithm>
#include <cstdlib>

namespace sinew::test {
namespace fs = std::filesystem;

std::vector<fs::path> files_below(const fs::path& folder, const std::vector<std::string>& extensions) {
  std::vector<fs::path> files;
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() &&
        std::find(extensions.begin(), extensions.end(), entry.path().extension().string()) != extensions.end())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::optional<fs::path> corpus() {
  const char* named = std::getenv("SINEW_CORPUS");
  const fs::path folder = named && *named ? fs::path(named) : fs::path(SINEW_SOURCE_DIR).parent_path() / "shared";
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return std::nullopt;
  return folder;
}

std::vector<fs::path> corpus_files(const std::string& folder, const std::vector<std::string>& extensions) {
  const auto root = corpus();
  return root ? files_below(*root / folder, extensions) : std::vector<fs::path>{};
}

}  // namespace sinew::test
