// SPDX-License-Identifier: MIT
#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "importer/geometry_cache/encode_geometry_cache.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "samples/showcase/flag_cloth.h"
#include "tests/bench/measure.h"

namespace sinew::bench {
namespace {

constexpr double kBudget = 1e-4;
constexpr std::uint32_t kFrames = 128;

/// A baked cloth of 29,949 vertices, and the same frames compressed with plain zstd.
struct Cloth {
  std::vector<std::vector<glm::vec3>> frames;
  std::vector<std::byte> file;
  GeometryCache cache;
  std::vector<std::vector<char>> by_zstd;  // frames of 16-bit numbers, at level 19
  std::size_t quantised_bytes = 0;         // size of one frame
};

/// Coordinates as 16-bit numbers in steps of the cache's grid.
std::vector<std::uint16_t> quantised(const std::vector<glm::vec3>& frame, double step) {
  std::vector<std::uint16_t> out;
  for (const glm::vec3& p : frame)
    for (int axis = 0; axis < 3; ++axis) out.push_back(static_cast<std::uint16_t>(std::lround(p[axis] / step)));
  return out;
}

std::shared_ptr<Cloth> make_cloth(const showcase::FlagWind& wind) {
  auto out = std::make_shared<Cloth>();
  showcase::ClothFrames cloth = showcase::fly_flag({.frame_count = kFrames, .wind = wind});
  GeometryTake take;
  TakeMesh& mesh = take.meshes.emplace_back();
  mesh.vertex_count = static_cast<std::uint32_t>(cloth.frames[0].size());
  mesh.triangles = std::move(cloth.triangles);
  mesh.streams.push_back({GeometryKind::positions, cloth.frames, kBudget});
  out->frames = std::move(cloth.frames);
  out->file = *encode_geometry_cache(take);
  out->cache = *GeometryCache::open(out->file);
  for (const auto& frame : out->frames) {
    const auto numbers = quantised(frame, 2.0 * kBudget / std::sqrt(3.0));
    out->quantised_bytes = numbers.size() * sizeof(numbers[0]);
    auto& packed = out->by_zstd.emplace_back(ZSTD_compressBound(out->quantised_bytes));
    packed.resize(ZSTD_compress(packed.data(), packed.size(), numbers.data(), out->quantised_bytes, 19));
  }
  return out;
}

/// Decodes the cloth's frames in an endless loop.
struct Player {
  std::shared_ptr<Cloth> cloth;
  GeometryDecoder decoder;
  MappedFrames source;
  std::vector<glm::vec3> out;
  std::uint32_t frame = 0;

  explicit Player(std::shared_ptr<Cloth> of)
      : cloth(std::move(of)), decoder(cloth->cache), source{cloth->cache, cloth->file}, out(cloth->frames[0].size()) {}
  void show(std::uint32_t f) {
    decoder.decode(f, source);
    decoder.write_points(0, out);
    benchmark::DoNotOptimize(out.data());
  }
};

/// Reports sizes relative to raw floats: all frames with the directory, and plain zstd.
void report_sizes(const Cloth& cloth, benchmark::State& state) {
  const double raw = 12.0 * static_cast<double>(cloth.frames[0].size()) * kFrames;
  double zstd = 0.0;
  for (const auto& frame : cloth.by_zstd) zstd += static_cast<double>(frame.size());
  state.counters["of_raw"] = static_cast<double>(cloth.file.size()) / raw;
  state.counters["zstd_of_raw"] = zstd / raw;
}

/// A calm and a lively wind. A cache stores how vertices move relative to their neighbours, so a lively cloth takes
/// more.
constexpr showcase::FlagWind kCalm{}, kLively{.speed = 8.0, .gust = 3.4, .lift = 1.8, .swing = 4.6, .wave = 10.0};

void add_forward(const std::string& name, const std::shared_ptr<Cloth>& cloth) {
  const std::size_t points = cloth->frames[0].size();
  Facts facts;
  facts.error = cloth->cache.meshes()[0].certificate.measured_m;
  facts.bytes = points * sizeof(glm::vec3);
  facts.report = [cloth](benchmark::State& state) { report_sizes(*cloth, state); };
  const auto player = std::make_shared<Player>(cloth);
  add(
      "geometry_cache/" + name, points, [player] { player->show(player->frame = (player->frame + 1) % kFrames); },
      facts);
}

}  // namespace

void add_geometry_cache() {
  const std::shared_ptr<Cloth> cloth = make_cloth(kCalm);
  const std::size_t points = cloth->frames[0].size();
  Facts facts;
  facts.error = cloth->cache.meshes()[0].certificate.measured_m;
  facts.bytes = points * sizeof(glm::vec3);
  const auto add_player = [&](const std::string& name, const auto& work, const Facts& about) {
    const auto player = std::make_shared<Player>(cloth);
    add(
        "geometry_cache/" + name, points, [player, work] { work(*player); }, about);
  };
  add_forward("sinew/cloth30k/forward", cloth);
  add_forward("sinew/lively_cloth30k/forward", make_cloth(kLively));
  add_player(
      "sinew/cloth30k/vertices",
      [](Player& p) {
        p.decoder.decode(p.frame = (p.frame + 1) % kFrames, p.source);
        p.decoder.write_vertices(0, p.out);
        benchmark::DoNotOptimize(p.out.data());
      },
      facts);
  add_player(
      "sinew/cloth30k/farthest_seek", [](Player& p) { p.show(p.frame = p.frame == 31 ? 63 : 31); }, facts);
  add_player(
      "sinew/cloth30k/open_and_first_frame",
      [](Player& p) {
        const auto cache = GeometryCache::open(p.cloth->file);
        GeometryDecoder decoder(*cache);
        decoder.decode(0, p.source);
        decoder.write_points(0, p.out);
        benchmark::DoNotOptimize(p.out.data());
      },
      facts);
  add_player(
      "zstd/cloth30k/forward",
      [](Player& p) {
        const auto& packed = p.cloth->by_zstd[p.frame = (p.frame + 1) % kFrames];
        ZSTD_decompress(p.out.data(), p.out.size() * sizeof(glm::vec3), packed.data(), packed.size());
        benchmark::DoNotOptimize(p.out.data());
      },
      facts);
  add_player(
      "copy/cloth30k/forward",
      [](Player& p) {
        const auto& frame = p.cloth->frames[p.frame = (p.frame + 1) % kFrames];
        std::memcpy(p.out.data(), frame.data(), frame.size() * sizeof(glm::vec3));
        benchmark::DoNotOptimize(p.out.data());
      },
      facts);
}

}  // namespace sinew::bench
