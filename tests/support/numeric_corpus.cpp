// SPDX-License-Identifier: MIT
#include "tests/support/numeric_corpus.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "tests/support/corpus.h"
#include "tests/support/numeric_metrics.h"

namespace sinew::test {
namespace {

std::vector<std::filesystem::path> all_paths() {
  std::vector<std::filesystem::path> paths = corpus_files("numeric", {".json"});
  for (const auto& entry : std::filesystem::directory_iterator(SINEW_NUMERIC_CASES))
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<Json> read_files() {
  std::vector<Json> files;
  for (const auto& path : all_paths()) {
    std::ifstream stream(path);
    Json file = Json::parse(stream, nullptr, false);
    if (file.is_discarded() || !file.contains("cases"))
      throw std::runtime_error(path.string() + " is not reference data");
    files.push_back(std::move(file));
  }
  return files;
}

std::string kind_of(const Json& file, const Json& entry) {
  return entry.contains("kind") ? entry["kind"].get<std::string>() : file.value("kind", std::string("unnamed"));
}

}  // namespace

std::vector<Json> numeric_cases(const std::string& kind) {
  static const std::vector<Json> files = read_files();
  std::vector<Json> cases;
  for (const Json& file : files)
    for (const Json& entry : file["cases"])
      if (kind_of(file, entry) == kind) cases.push_back(entry);
  return cases;
}

std::vector<std::string> numeric_kinds() {
  std::set<std::string> kinds;
  for (const Json& file : read_files())
    for (const Json& entry : file["cases"]) kinds.insert(kind_of(file, entry));
  return {kinds.begin(), kinds.end()};
}

NumericReport run_numeric(const std::vector<Json>& cases, const NumericVariant& variant) {
  NumericReport report;
  constexpr int kShown = 8;
  for (const Json& entry : cases) {
    const Outcome got = variant.run(entry["in"]);
    if (got.empty()) continue;
    ++report.run;
    const double miss = numeric_miss(entry, got);
    if (!(miss <= 1) && ++report.failed <= kShown)
      report.failures +=
          "  " + entry["name"].get<std::string>() + ": " + std::to_string(miss) + " times the tolerance\n";
    if (!(miss <= report.worst)) {
      report.worst = miss;
      report.worst_case = entry["name"].get<std::string>();
    }
  }
  return report;
}

}  // namespace sinew::test
