// SPDX-License-Identifier: MIT
#include "runtime/procedures/springs/spring_inputs.h"

#include <algorithm>

namespace sinew::springs {

InputFrame input_frame_of(const Affined& world) noexcept {
  const Mat linear = linear_part(world);
  const double sign = determinant(world) < 0.0 ? -1.0 : 1.0;
  const Vec x = direction_of(linear[0] * sign, Vec(1, 0, 0));
  const Vec beside = linear[1] * sign;
  const Vec y = direction_of(beside - x * dot(x, beside), perpendicular_to(x));
  const Rot rotation = quat_from_matrix(Mat(x, y, glm::cross(x, y)));
  return {translation_of(world), rotation, glm::transpose(matrix_from_unit_quat(rotation)) * linear};
}

FrameWeights weights_at(double fraction, double now_s, double before_s) noexcept {
  if (fraction >= 1.0 || !(before_s > 0.25 * now_s && before_s < 4.0 * now_s)) return {0.0, 1.0 - fraction, fraction};
  const double bend = fraction * (fraction - 1.0) * now_s / (now_s + before_s);
  const double earlier = bend * now_s / before_s, now = fraction + bend;
  return {earlier, 1.0 - now - earlier, now};
}

InputFrame interpolated(const InputFrame& earlier, const InputFrame& before, const InputFrame& now,
                        const FrameWeights& weights) noexcept {
  if (weights.now == 1.0 || (before == now && (weights.earlier == 0.0 || earlier == now))) return now;
  const auto mean = [&](const auto& a, const auto& b, const auto& c) {
    return a * weights.earlier + b * weights.before + c * weights.now;
  };
  InputFrame out;
  out.at = mean(earlier.at, before.at, now.at);
  out.rotation = normalised_or(
      mean(aligned_with(now.rotation, earlier.rotation), aligned_with(now.rotation, before.rotation), now.rotation),
      now.rotation);
  out.shape = mean(earlier.shape, before.shape, now.shape);
  return out;
}

void place(const InputFrame& from, bool is_uniform, const Planes<double>& frames, std::size_t slot) noexcept {
  const auto write = [&](std::size_t first, const Vec& v) {
    for (int i = 0; i < 3; ++i) frames.at(first + static_cast<std::size_t>(i), slot) = v[i];
  };
  write(0, from.at);
  if (!is_uniform) {
    const Mat linear = matrix_of(from).linear;
    for (int c = 0; c < 3; ++c) write(3 + 3 * static_cast<std::size_t>(c), linear[c]);
    return;
  }
  write(3, {from.rotation.x, from.rotation.y, from.rotation.z});
  frames.at(6, slot) = from.rotation.w;
  frames.at(7, slot) = (from.shape[0].x + from.shape[1].y + from.shape[2].z) * (1.0 / 3.0);
}

bool is_uniform(const InputFrame& frame) noexcept {
  const Mat& m = frame.shape;
  const double scale = (m[0].x + m[1].y + m[2].z) * (1.0 / 3.0);
  double off = 0.0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) off = (std::max)(off, std::abs(m[c][r] - (c == r ? scale : 0.0)));
  return off <= 4e-6 * std::abs(scale);
}

}  // namespace sinew::springs
