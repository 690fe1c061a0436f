// SPDX-License-Identifier: MIT
// Records which motion the encoder chooses for blocks of many kinds, and the size of the residuals. Any motion decodes
// to the right points, so only this test notices a larger choice. After a deliberate change:
//     SINEW_RECORD=1 build/release/bin/sinew-test-geometry-cache --gtest_filter='chosen_blocks.*'
// writes tests/golden/chosen_blocks.txt; bytes should not have grown.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "importer/geometry_cache/fit_block.h"
#include "runtime/base/bit_hash.h"
#include "runtime/geometry_cache/block_headers.h"
#include "runtime/geometry_cache/geometry_format.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

constexpr const char* kStored = SINEW_SOURCE_DIR "/tests/golden/chosen_blocks.txt";
constexpr double kReach = 0.8660254037844387;  // half the diagonal of a cube

/// A bent grid of 8 by 8 points, in the integer steps that caches store, in the last two frames (x1 is the later one).
struct Sheet {
  BlockState x1{}, x2{};
  std::vector<std::uint8_t> corners = std::vector<std::uint8_t>(kBlockNumbers, kNoCorner);
};

Sheet sheet(FixedRandom& random, double size, double past) {
  Sheet out;
  for (std::size_t i = 0; i < kBlockPoints; ++i) {
    const double u = static_cast<double>(i % 8) / 8.0, v = static_cast<double>(i / 8) / 8.0;
    const double place[] = {size * u, size * v, size * (0.3 * u * u - 0.2 * u * v)};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t n = a * kBlockPoints + i;
      out.x1[n] = static_cast<std::int32_t>(place[a] + random.in(-2, 2));
      out.x2[n] = out.x1[n] + static_cast<std::int32_t>(random.in(-past, past));
    }
    if (i == 0) continue;
    const bool left = i % 8 == 0, top = i < 8;
    out.corners[3 * i] = static_cast<std::uint8_t>(left ? i - 8 : i - 1);
    if (left || top) continue;
    out.corners[3 * i + 1] = static_cast<std::uint8_t>(i - 8);
    out.corners[3 * i + 2] = static_cast<std::uint8_t>(i - 9);
  }
  return out;
}

/// Moves a point; `t` scales the motion.
using Motion = std::function<void(const Sheet& sheet, std::size_t i, double t, double* p)>;

struct Kind {
  const char* name;
  Motion motion;
};

std::vector<Kind> kinds() {
  return {{"still", [](const Sheet&, std::size_t, double, double*) {}},
          {"shifted",
           [](const Sheet&, std::size_t, double t, double* p) {
             p[0] += 300 * t;
             p[2] -= 7 * t;
           }},
          {"turned",
           [](const Sheet&, std::size_t, double t, double* p) {
             const double x = p[0], y = p[1];
             p[0] += -0.1 * t * y;
             p[1] += 0.1 * t * x + 5;
           }},
          {"bent",
           [](const Sheet&, std::size_t i, double t, double* p) {
             const double u = static_cast<double>(i % 8), v = static_cast<double>(i / 8);
             p[2] += t * (u * u - 0.5 * v * v * u);
           }},
          {"going on",
           [](const Sheet& sheet, std::size_t i, double t, double* p) {
             for (std::size_t a = 0; a < 3; ++a) {
               const std::size_t n = a * kBlockPoints + i;
               p[a] += t * (sheet.x1[n] - sheet.x2[n]);
             }
           }},
          {"waving", [](const Sheet&, std::size_t i, double t, double* p) {
             const double u = static_cast<double>(i % 8) - 3.5;
             p[1] += 20 * t * (u - u * u * u / 16.0);
             p[2] += 9 * t * u;
           }}};
}

/// Fits some blocks of one kind. Returns their bases, their bytes and a hash of their content.
std::string chosen(const Kind& kind, double noise) {
  FixedRandom random(3);
  BitHash hash;
  std::size_t taken[4] = {}, turning = 0, spreading = 0, payload = 0, heads = 0;
  for (int round = 0; round < 24; ++round) {
    const double size = round % 3 == 0 ? 60.0 : round % 3 == 1 ? 900.0 : 300000.0, t = 0.2 * (1 + round / 3);
    const Sheet before = sheet(random, size, round % 2 == 0 ? 3.0 : 40.0);
    BlockValues values{};
    for (std::size_t i = 0; i < kBlockPoints; ++i) {
      double p[3];
      for (std::size_t a = 0; a < 3; ++a) p[a] = before.x1[a * kBlockPoints + i];
      kind.motion(before, i, t, p);
      for (std::size_t a = 0; a < 3; ++a) values[a * kBlockPoints + i] = p[a] + random.in(-noise, noise);
    }
    const std::size_t count = round % 4 == 3 ? 37 : kBlockPoints;
    const FittedBlock block =
        round % 8 == 7 ? fit_in_space(values, count, before.corners, kReach)
                       : fit_in_time(values, count, before.corners, before.x1, before.x2, round % 5 != 4, kReach);
    ++taken[static_cast<std::size_t>(block.motion.base)];
    turning += block.motion.turns;
    spreading += block.motion.spreads;
    payload += payload_bytes(std::span(&block.motion, 1));
    const BlockHeaderBytes head = write_block_headers(std::span(&block.motion, 1));
    heads += head.coarse.size() + head.fine.size();
    for (const auto* section : {&head.coarse, &head.fine})
      for (const std::uint8_t byte : *section)
        hash.add(std::span<const std::uint32_t>(std::array{std::uint32_t{byte}}));
    hash.add(std::span<const std::int32_t>(block.residuals));
  }
  std::ostringstream out;
  out << kind.name << ", noise " << noise << ": space " << taken[0] << ", last " << taken[1] << ", linear " << taken[2]
      << ", slower " << taken[3] << "; turning " << turning << ", spreading " << spreading << "; " << heads << " + "
      << payload << " bytes, " << std::hex << hash.value() << "\n";
  return out.str();
}

TEST(chosen_blocks, the_search_takes_what_is_stored) {
  std::string text;
  for (const Kind& kind : kinds())
    for (const double noise : {0.25, 2.0, 12.0, 150.0}) text += chosen(kind, noise);
  if (std::getenv("SINEW_RECORD") != nullptr) std::ofstream(kStored) << text;
  std::ifstream in(kStored);
  std::ostringstream stored;
  stored << in.rdbuf();
  EXPECT_EQ(text, stored.str());
}

}  // namespace
}  // namespace sinew::test
