// SPDX-License-Identifier: MIT
// Matrices in model space. ozz numbers joints depth first, sinew breadth first: `Tree::order` says which joint of ozz
// each is. A range of ozz (from, to) is a list `only` of sinew.
#include <algorithm>
#include <vector>

#include "runtime/pose/local_to_model.h"
#include "tests/ozz_numbers/tally.h"
#include "tests/support/tiny_assets.h"

namespace sinew::ozz {
namespace {

/// A matrix of the tests: a scale, maybe a quarter turn about y, and a translation.
struct Numbers {
  float scale = 1.0f;
  bool turned = false;
  glm::vec3 translation{0.0f};
};

Affine matrix_of(const Numbers& n) {
  const float s = n.scale;
  const Mat3<float> linear =
      n.turned ? Mat3<float>(0, 0, -s, 0, s, 0, s, 0, 0) : Mat3<float>(s, 0, 0, 0, s, 0, 0, 0, s);
  return affine_from(linear, n.translation);
}

struct Tree {
  std::vector<std::uint32_t> order;    ///< joint of ozz for each joint of sinew
  std::vector<std::uint32_t> parents;  ///< of the joints of sinew
  std::vector<Numbers> local, model;   ///< in ozz's order
};

/// Composes the joints of ozz in `only`, or all.
void compose(const Tree& tree, const Affine& root, const std::vector<std::uint32_t>& only, std::vector<Affine>& model) {
  const Skeleton skeleton = test::skeleton_of(tree.parents);
  test::PoseBuffer pose(tree.order.size());
  std::vector<std::uint32_t> joints;
  for (std::uint32_t j = 0; j < tree.order.size(); ++j) {
    const Numbers& n = tree.local[tree.order[j]];
    const float half = n.turned ? 0.70710677f : 0.0f;
    pose.span().set(j, {n.translation, quat_xyzw(0.0f, half, 0.0f, n.turned ? half : 1.0f), glm::vec3(n.scale)});
    if (std::find(only.begin(), only.end(), tree.order[j]) != only.end()) joints.push_back(j);
  }
  EXPECT_EQ(run(LocalToModelJob{&skeleton, pose.span(), root, model, joints}), ErrorCode::ok);
}

void compare_matrices(const Tree& tree, const std::vector<Affine>& found, const std::vector<Affine>& expected,
                      Tally& tally) {
  for (std::size_t j = 0; j < found.size(); ++j)
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c)
        compare(double(found[j].row[r][c]), double(expected[tree.order[j]].row[r][c]), kTolerance, tally);
}

}  // namespace

Tally model_matrices_group() {
  const Tree tree{
      {0, 1, 3, 2, 4, 5},
      {kNone, 0, 0, 1, 2, 2},
      {{1, false, {2, 2, 2}},
       {1, true},
       {1, false, {1, 2, 4}},
       {10, false, {-2, -2, -2}},
       {1, false, {12, 46, -12}},
       {-0.1f}},
      {{1, false, {2, 2, 2}}, {1, true, {2, 2, 2}}, {1, true, {6, 4, 1}}, {10}, {10, false, {120, 460, -120}}, {-1}}};
  Tally tally;
  for (const glm::vec3 root : {glm::vec3(0.0f), glm::vec3(4, 3, 2)}) {
    std::vector<Affine> found(6), expected;
    for (Numbers n : tree.model) {
      n.translation += root;
      expected.push_back(matrix_of(n));
    }
    compose(tree, matrix_of({.translation = root}), {}, found);
    compare_matrices(tree, found, expected, tally);
  }
  return tally;
}

Tally model_ranges_group() {
  const Tree tree{{0, 7, 1, 3, 2, 4, 6, 5},
                  {kNone, kNone, 0, 0, 2, 3, 3, 5},
                  {{1, false, {2, 2, 2}},
                   {1, true},
                   {10, false, {-2, -2, -2}},
                   {1, false, {1, 2, 4}},
                   {1, false, {12, 46, -12}},
                   {-0.1f},
                   {1, false, {3, 4, 5}},
                   {1, false, {6, 7, 8}}},
                  {{1, false, {2, 2, 2}},
                   {1, true, {2, 2, 2}},
                   {10, true, {0, 0, 4}},
                   {1, false, {3, 4, 6}},
                   {1, false, {15, 50, -6}},
                   {-0.1f, false, {15, 50, -6}},
                   {1, false, {6, 8, 11}},
                   {1, false, {6, 7, 8}}}};
  const struct {
    std::vector<std::uint32_t> kept, only;  ///< joints that keep their matrix, and those to compose; others are reset
  } cases[] = {{{}, {0, 1, 2, 3, 4, 5, 6}}, {{}, {7}}, {{0}, {1, 2}}, {{0}, {3, 4, 5, 6}}, {{4}, {5}}, {{3}, {6}}};
  std::vector<Affine> full(8), all;
  for (const Numbers& n : tree.model) all.push_back(matrix_of(n));
  compose(tree, Affine{}, {}, full);
  Tally tally;
  compare_matrices(tree, full, all, tally);
  for (const auto& c : cases) {
    std::vector<Affine> found = full, expected(8);
    for (const auto& list : {c.kept, c.only})
      for (const std::uint32_t joint : list) expected[joint] = all[joint];
    for (std::size_t j = 0; j < found.size(); ++j)
      if (std::find(c.kept.begin(), c.kept.end(), tree.order[j]) == c.kept.end()) found[j] = Affine{};
    compose(tree, Affine{}, c.only, found);
    compare_matrices(tree, found, expected, tally);
  }
  return tally;
}

}  // namespace sinew::ozz
