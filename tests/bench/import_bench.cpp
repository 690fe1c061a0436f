// SPDX-License-Identifier: MIT
#include "importer/import_gltf.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "importer/export_glb.h"
#include "importer/file/data_uri.h"
#include "samples/showcase/showcase.h"
#include "tests/bench/measure.h"
#include "tests/bench/tinygltf_parse.h"
#include "tests/support/corpus.h"

namespace sinew::bench {
namespace {

/// A file in memory or on disk. Neither importer decodes images.
struct Source {
  std::string name;
  std::variant<std::vector<std::byte>, std::filesystem::path> data;
  std::size_t bytes = 0;  ///< total with all buffers
};

/// Time spent in each stage of an import; progress reports give the names of the stages.
class StageClock {
 public:
  using Clock = std::chrono::steady_clock;

  void enter(const char* stage) {
    const auto now = Clock::now();
    if (!stage_.empty()) spent_s_[stage_] += std::chrono::duration<double>(now - since_).count();
    stage_ = stage;
    since_ = now;
  }

  /// Adds each stage's share of the time to the counters of the case.
  void report(benchmark::State& state) {
    double total_s = 0.0;
    for (const auto& [stage, seconds] : spent_s_) total_s += seconds;
    for (const auto& [stage, seconds] : spent_s_) state.counters["part:" + stage] = seconds / total_s;
    spent_s_.clear();
  }

  void end() { stage_.clear(); }

 private:
  std::string stage_;
  Clock::time_point since_;
  std::map<std::string, double> spent_s_;
};

ImportResult<ImportedFile> import_source(const Source& source, const ImportOptions& options) {
  if (const auto* bytes = std::get_if<std::vector<std::byte>>(&source.data))
    return import_gltf(*bytes, source.name, options);
  return import_gltf(std::get<std::filesystem::path>(source.data), options);
}

int parse_source(const Source& source) {
  if (const auto* bytes = std::get_if<std::vector<std::byte>>(&source.data)) return parse_with_tinygltf(*bytes);
  return parse_with_tinygltf(std::get<std::filesystem::path>(source.data));
}

/// Compares the whole import with tinygltf's parsing alone; an item is one byte of the files.
void add_sources(const std::string& name, std::shared_ptr<const std::vector<Source>> sources) {
  std::size_t bytes = 0;
  for (const Source& source : *sources) bytes += source.bytes;
  const auto clock = std::make_shared<StageClock>();
  ImportOptions options;
  options.decode_images = false;
  options.progress = [clock](const char* stage, double) { clock->enter(stage); };
  Facts facts;
  facts.bytes = bytes;
  facts.wall_time = true;  // includes work on other threads
  facts.report = [clock](benchmark::State& state) { clock->report(state); };
  add(
      "import/sinew/" + name, bytes,
      [sources, options, clock] {
        for (const Source& source : *sources) {
          if (!import_source(source, options)) std::abort();
          clock->end();
        }
      },
      facts);
  facts.report = nullptr;
  add(
      "import/tinygltf/" + name, bytes,
      [sources] {
        for (const Source& source : *sources)
          if (parse_source(source) < 0) std::abort();
      },
      facts);
}

bool is_compressed(const ImportedFile& file) {
  const auto& used = file.facts.extensions_used;
  return std::any_of(used.begin(), used.end(), [](const std::string& name) { return name.ends_with("_compression"); });
}

/// Every uncompressed model of the corpus that both importers can read.
std::vector<Source> corpus_sources() {
  std::vector<Source> out;
  ImportOptions options;
  options.decode_images = false;
  for (const auto& path : test::corpus_files("models", {".gltf", ".glb"})) {
    const auto file = import_gltf(path, options);
    if (!file || is_compressed(*file) || parse_with_tinygltf(path) < 0) continue;
    out.push_back({path.parent_path().filename().string(), path, static_cast<std::size_t>(file->facts.file_bytes)});
  }
  return out;
}

/// Decodes a data URI, beside a copy of its text.
void add_base64() {
  constexpr std::size_t kSize = std::size_t{1} << 20;
  std::string text(kSize, 'A');
  for (std::size_t i = 0; i < kSize; ++i) text[i] = static_cast<char>('A' + i * 7 % 26);
  const auto uri = std::make_shared<const std::string>("data:application/octet-stream;base64," + text);
  Facts facts;
  facts.bytes = kSize + kSize / 4 * 3;
  add(
      "base64/sinew/1M", kSize,
      [uri] {
        if (!decode_data_uri(*uri)) std::abort();
      },
      facts);
  facts.bytes = 2 * kSize;
  add(
      "base64/copy/1M", kSize,
      [uri] {
        const std::string copy(*uri);
        benchmark::DoNotOptimize(copy.data());
      },
      facts);
}

}  // namespace

void add_import() {
  add_base64();
  for (const auto& scene : showcase::showcase()) {
    auto bytes = export_glb(scene.scene);
    if (!bytes) std::abort();
    Source source{scene.name.substr(scene.name.find(' ') + 1), *bytes, bytes->size()};
    const std::string name = source.name;
    add_sources(name, std::make_shared<const std::vector<Source>>(1, std::move(source)));
  }
  auto models = corpus_sources();
  if (models.empty()) return;
  for (const Source& source : models) add_sources(source.name, std::make_shared<const std::vector<Source>>(1, source));
  add_sources("corpus", std::make_shared<const std::vector<Source>>(std::move(models)));
}

}  // namespace sinew::bench
