// SPDX-License-Identifier: MIT
#include "tests/support/corpus.h"

namespace sinew::test {
namespace fs = std::filesystem;

std::vector<fs::path> files_for_tests(const std::string& folder, const std::vector<std::string>& extensions) {
  std::vector<fs::path> files = files_below(fs::path(SINEW_GENERATED_MODELS) / folder, extensions);
  const std::vector<fs::path> others = corpus_files(folder, extensions);
  files.insert(files.end(), others.begin(), others.end());
  return files;
}

}  // namespace sinew::test
