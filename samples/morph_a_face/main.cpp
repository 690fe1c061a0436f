// SPDX-License-Identifier: MIT
// A mouth of five vertices and two morph targets, "smile" and "open". Only vertices that a target moves are stored;
// weights may be negative or above one.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <span>

#include <sinew/deform_jobs.h>
#include <sinew/morphs.h>
#include <glm/vec3.hpp>

namespace {

using namespace sinew;

constexpr std::size_t kVertices = 5;
constexpr std::array<const char*, kVertices> kNames = {"left corner", "right corner", "upper lip", "lower lip", "chin"};
constexpr std::array<glm::vec3, kVertices> kFace = {glm::vec3{-0.03f, 0.0f, 0.0f},
                                                    {0.03f, 0.0f, 0.0f},
                                                    {0.0f, 0.005f, 0.0f},
                                                    {0.0f, -0.005f, 0.0f},
                                                    {0.0f, -0.05f, 0.0f}};

/// Target 0 lifts both corners; target 1 parts the lips and lowers the chin.
MorphSet make_targets() {
  MorphTarget smile, open;
  smile.positions.vertices = {0, 1};
  smile.positions.deltas = {{-0.01f, 0.012f, 0.0f}, {0.01f, 0.012f, 0.0f}};
  open.positions.vertices = {2, 3, 4};
  open.positions.deltas = {{0.0f, 0.004f, 0.0f}, {0.0f, -0.02f, 0.0f}, {0.0f, -0.018f, 0.0f}};
  return {{smile, open}};
}

bool parse_weight(const char* text, float& weight) {
  char* end = nullptr;
  weight = std::strtof(text, &end);
  return end != text && *end == '\0' && weight - weight == 0.0f;  // a number, and finite
}

}  // namespace

int main(int argc, char** argv) {
  std::array<float, 2> weights = {1.0f, 0.5f};
  if ((argc != 1 && argc != 3) ||
      (argc == 3 && (!parse_weight(argv[1], weights[0]) || !parse_weight(argv[2], weights[1])))) {
    std::fprintf(stderr, "usage: morph_a_face [SMILE OPEN]   weights, for example 1 0.5 or -0.4 1.5\n");
    return 2;
  }

  const MorphSet targets = make_targets();
  std::array<glm::vec3, kVertices> moved{}, scratch{};
  const MorphVerticesJob morph{.morphs = &targets,
                               .weights = weights,
                               .vertices = {.positions = kFace, .normals = {}, .tangents = {}},
                               .out = {.positions = moved, .normals = {}, .tangents = {}},
                               .scratch = scratch};
  if (const ErrorCode code = run(morph); code != ErrorCode::ok) {
    std::fprintf(stderr, "%s\n", describe(code).data());
    return 1;
  }

  std::printf("smile %g, open %g\n", weights[0], weights[1]);
  for (std::size_t v = 0; v < kVertices; ++v)
    std::printf("  %-12s %8.2f %8.2f mm\n", kNames[v], 1000.0f * moved[v].x, 1000.0f * moved[v].y);
  // Only the target "open" moves the lower lip, by its weight times its displacement.
  const float expected = kFace[3].y + weights[1] * -0.02f;
  const float off = moved[3].y - expected;
  return off * off <= 1e-14f * (1.0f + expected * expected) ? 0 : 1;
}
