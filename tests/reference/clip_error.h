// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/pose/sample_clip.h"
#include "tests/reference/sampling.h"
#include "tests/support/tiny_assets.h"

namespace sinew::reference {

/// Distance of a clip from its animation, in long double, from the equations only. Certificates are held to it.

/// Three rows of four.
using Matrix = std::array<std::array<Real, 4>, 3>;

inline Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t i = 0; i < 3; ++i) c[r][k] += a[r][i] * b[i][k];
      if (k == 3) c[r][k] += a[r][3];
    }
  return c;
}

/// eq   p' = q (s p) q* + t, column by column, by the triple product
inline Matrix matrix_of(const Numbers& t, const Numbers& q, const Numbers& s) {
  Matrix m{};
  const auto cross = [](const Numbers& a, const Numbers& b) {
    return Numbers{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  for (std::size_t c = 0; c < 3; ++c) {
    Numbers p{0, 0, 0};
    p[c] = s[c];
    const Numbers v{q[0], q[1], q[2]}, u = cross(v, p), w = cross(v, u);
    for (std::size_t r = 0; r < 3; ++r) m[r][c] = p[r] + 2 * q[3] * u[r] + 2 * w[r];
  }
  for (std::size_t r = 0; r < 3; ++r) m[r][3] = t[r];
  return m;
}

struct LocalNumbers {
  Numbers translation, rotation, scale;
};

inline std::vector<Matrix> model_of(const Skeleton& skeleton, const std::vector<LocalNumbers>& local) {
  std::vector<Matrix> model;
  for (std::size_t j = 0; j < local.size(); ++j) {
    Matrix own = matrix_of(local[j].translation, local[j].rotation, local[j].scale);
    if (const std::uint32_t fixed = skeleton.fixed_matrix_of[j]; fixed != kNone)
      for (std::size_t r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c)
          own[r][static_cast<std::size_t>(c)] = Real(skeleton.fixed_matrices[fixed].row[r][c]);
    model.push_back(skeleton.parents[j] == kNone ? own : product(model[skeleton.parents[j]], own));
  }
  return model;
}

inline LocalNumbers local_of(const Transform& t) {
  return {numbers(t.translation), numbers(t.rotation), numbers(t.scale)};
}

/// Largest distance of any corner of each joint's box at one time, [J].
inline std::vector<Real> joint_errors(const Skeleton& skeleton, const Animation& truth, const std::vector<Aabb>& boxes,
                                      const Clip& clip, double time_s) {
  std::vector<LocalNumbers> expected, found;
  for (const Transform& rest : skeleton.rest) expected.push_back(local_of(rest));
  for (const BoneAnimation& bone : truth.bones) {
    LocalNumbers& local = expected[bone.joint];
    if (!bone.translation.empty()) local.translation = sample(bone.translation, time_s);
    if (!bone.rotation.empty()) local.rotation = sample(bone.rotation, time_s);
    if (!bone.scale.empty()) local.scale = sample(bone.scale, time_s);
  }
  test::PoseBuffer pose(skeleton.joint_count());
  run_unchecked(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = {}});
  for (std::size_t j = 0; j < skeleton.joint_count(); ++j) found.push_back(local_of(pose.span().get(j)));
  const std::vector<Matrix> a = model_of(skeleton, expected), b = model_of(skeleton, found);
  std::vector<Real> errors(a.size(), 0);
  for (std::size_t j = 0; j < a.size(); ++j)
    for (const float x : {boxes[j].lower.x, boxes[j].upper.x})
      for (const float y : {boxes[j].lower.y, boxes[j].upper.y})
        for (const float z : {boxes[j].lower.z, boxes[j].upper.z}) {
          Real sum = 0;
          for (std::size_t r = 0; r < 3; ++r) {
            const Real d = (b[j][r][0] - a[j][r][0]) * Real(x) + (b[j][r][1] - a[j][r][1]) * Real(y) +
                           (b[j][r][2] - a[j][r][2]) * Real(z) + (b[j][r][3] - a[j][r][3]);
            sum += d * d;
          }
          errors[j] = std::max(errors[j], std::sqrt(sum));
        }
  return errors;
}

}  // namespace sinew::reference
