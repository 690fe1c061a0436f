// SPDX-License-Identifier: MIT
// Two vertices with one to five influences. The last weight of a vertex is what the others leave, here also below 0.
#include <array>
#include <iterator>
#include <tuple>

#include "runtime/deform/skin_linear.h"
#include "runtime/deform/skin_strided.h"
#include "tests/ozz_numbers/tally.h"

namespace sinew::ozz {
namespace {

struct SkinningCase {
  glm::vec3 positions[2], directions[2];
};

constexpr SkinningCase kCases[] = {
    {{{-1, 2, -3}, {5, 7, 9}}, {{-0.1f, 0.2f, -0.3f}, {0.4f, 0.5f, 0.6f}}},
    {{{0.5f, 3, 1.5f}, {4.1f, 9.7f, 17.1f}}, {{0, 0.2f, 0}, {0.4f, 0.95f, 1.68f}}},
    {{{0.25f, 3, 2.25f}, {4.75f, 7.75f, 11.25f}}, {{0, 0.25f, 0.15f}, {0.4f, 0.625f, 0.9f}}},
    {{{0.25f, 3, 2.25f}, {1.15f, 6.95f, 5.25f}}, {{0, 0.25f, 0.15f}, {0.08f, 0.625f, 0.42f}}},
    {{{0.55f, 3.2f, 3.15f}, {3.4f, 7.45f, 9}}, {{0.02f, 0.25f, 0.21f}, {0.28f, 0.625f, 0.72f}}}};

constexpr std::uint16_t kJoints[2][5] = {{0, 1, 2, 3, 0}, {3, 2, 1, 0, 3}};
constexpr float kWeights[2][4] = {{0.5f, 0.25f, 0.25f, 0.1f}, {0.1f, 0.25f, 0.25f, 0.15f}};

VertexInfluences influences_of(std::uint32_t count) {
  VertexInfluences influences;
  influences.groups = {{0, 2, count, 0}};
  for (std::size_t v = 0; v < 2; ++v) {
    float left = 1.0f;
    for (std::uint32_t i = 0; i < count; ++i) {
      influences.joints.push_back(kJoints[v][i]);
      influences.weights.push_back(i + 1 < count ? kWeights[v][i] : left);
      left -= influences.weights.back();
    }
  }
  return influences;
}

/// ozz leaves the length that a direction gets; sinew makes it 1.
void compare_direction(const glm::vec3& found, const glm::vec3& expected, Tally& tally) {
  const glm::dvec3 unit = glm::normalize(glm::dvec3(expected));
  for (int c = 0; c < 3; ++c) compare(double(found[c]), unit[c], kTolerance, tally);
}

/// The vertices and matrices of all cases.
struct SkinningInput {
  std::array<JointMatrix, 4> palette;
  glm::vec3 positions[2] = {{1, 2, 3}, {4, 5, 6}}, normals[2] = {{0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f}};
  glm::vec4 tangents[2] = {{0.01f, 0.02f, 0.03f, 1}, {0.04f, 0.05f, 0.06f, 1}};

  SkinningInput() {
    Affine turned, moved, scaled;
    turned.row[0].x = turned.row[2].z = -1.0f;
    for (int r = 0; r < 3; ++r) {
      moved.row[r].w = static_cast<float>(r + 1);
      scaled.row[r][r] = static_cast<float>(r + 1);
    }
    palette = {joint_matrix_from(turned), joint_matrix_from(moved), joint_matrix_from(scaled),
               joint_matrix_from(moved)};
  }
};

struct SkinnedVertex {
  glm::vec3 position, normal;
  glm::vec4 tangent;
};

/// Calls `skin(influences, vertices)` for each number of influences, and compares the vertices that it writes.
template <class Skin>
Tally skinned_by(const Skin& skin) {
  Tally tally;
  for (std::uint32_t count = 1; count <= std::size(kCases); ++count) {
    SCOPED_TRACE(count);
    SkinnedVertex vertices[2];
    skin(influences_of(count), vertices);
    const SkinningCase& expected = kCases[count - 1];
    for (std::size_t v = 0; v < 2; ++v) {
      for (int c = 0; c < 3; ++c)
        compare(double(vertices[v].position[c]), double(expected.positions[v][c]), kTolerance, tally);
      compare_direction(vertices[v].normal, expected.directions[v], tally);
      compare_direction(glm::vec3(vertices[v].tangent), expected.directions[v], tally);
    }
  }
  return tally;
}

/// Attributes of an interleaved buffer whose vertices begin with `padding` bytes.
template <class Vec3, class Vec4, class Byte>
auto strided_over(Byte* bytes, std::size_t padding, std::size_t stride) {
  return std::tuple{StridedSpan<Vec3>{bytes + padding, 2, stride},
                    StridedSpan<Vec3>{bytes + padding + sizeof(glm::vec3), 2, stride},
                    StridedSpan<Vec4>{bytes + padding + 2 * sizeof(glm::vec3), 2, stride}};
}

}  // namespace

Tally skinning_group() {
  const SkinningInput in;
  return skinned_by([&](const VertexInfluences& influences, SkinnedVertex(&vertices)[2]) {
    glm::vec3 out[2], out_normals[2];
    glm::vec4 out_tangents[2];
    const SkinLinearJob job{
        &influences, in.palette, {in.positions, in.normals, in.tangents}, {out, out_normals, out_tangents}};
    EXPECT_EQ(run(job), ErrorCode::ok);
    for (std::size_t v = 0; v < 2; ++v) vertices[v] = {out[v], out_normals[v], out_tangents[v]};
  });
}

Tally skinning_strides_group() {
  constexpr std::size_t kStrideIn = 45, kStrideOut = 52;
  const SkinningInput in;
  std::byte from[2 * kStrideIn], to[2 * kStrideOut];
  const auto [positions, normals, tangents] = strided_over<glm::vec3, glm::vec4>(from, 1, kStrideIn);
  for (std::size_t v = 0; v < 2; ++v) {
    positions.store(v, in.positions[v]);
    normals.store(v, in.normals[v]);
    tangents.store(v, in.tangents[v]);
  }
  const auto [in_positions, in_normals, in_tangents] =
      strided_over<const glm::vec3, const glm::vec4>(static_cast<const std::byte*>(from), 1, kStrideIn);
  const auto [out_positions, out_normals, out_tangents] = strided_over<glm::vec3, glm::vec4>(to, 8, kStrideOut);
  const StridedInput strided_in{in_positions, in_normals, in_tangents};
  const StridedOutput strided_out{out_positions, out_normals, out_tangents};
  return skinned_by([&](const VertexInfluences& influences, SkinnedVertex(&vertices)[2]) {
    const StridedSkinJob<SkinLinearJob> job{
        {.influences = &influences, .palette = in.palette, .vertices = {}, .out = {}}, strided_in, strided_out};
    EXPECT_EQ(run(job), ErrorCode::ok);
    for (std::size_t v = 0; v < 2; ++v)
      vertices[v] = {strided_out.positions.load(v), strided_out.normals.load(v), strided_out.tangents.load(v)};
  });
}

}  // namespace sinew::ozz
