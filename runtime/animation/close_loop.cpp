// SPDX-License-Identifier: MIT
#include "runtime/animation/close_loop.h"

#include <algorithm>
#include <cmath>

#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

/// The keys of a track, with `width` numbers or vectors per row. Keys of cubic splines have three rows: in-tangent,
/// value, out-tangent.
template <class T>
struct KeyRows {
  T& track;
  std::size_t width;

  bool cubic() const noexcept { return track.interpolation == Interpolation::cubic_spline; }
  std::size_t row_size() const noexcept { return cubic() ? 3 * width : width; }
  auto in_tangents(std::size_t key) const noexcept { return track.values.begin() + at(key, 0); }
  auto values(std::size_t key) const noexcept { return track.values.begin() + at(key, cubic() ? 1 : 0); }
  auto out_tangents(std::size_t key) const noexcept { return track.values.begin() + at(key, 2); }

  /// Appends a key with the value of key `like` and tangents of 0.
  void append(float time_s, std::size_t like) const {
    const std::size_t key = track.times_s.size();
    track.times_s.push_back(time_s);
    track.values.resize(track.values.size() + row_size(), track.values[0] * 0.0f);
    std::copy_n(values(like), width, values(key));
  }

 private:
  std::ptrdiff_t at(std::size_t key, std::size_t part) const noexcept {
    return static_cast<std::ptrdiff_t>(key * row_size() + part * width);
  }
};

/// Cubic splines are evaluated without sign correction. So the closing key must be q or -q, whichever is nearer to the
/// last key.
void take_short_arc(const KeyRows<QuatTrack>& keys, std::size_t last) {
  if (!keys.cubic() || quat_dot(*keys.values(last), *keys.values(last + 1)) >= 0.0f) return;
  *keys.values(last + 1) = -*keys.values(last + 1);
  *keys.in_tangents(last + 1) = -*keys.in_tangents(last + 1);
}

template <class T>
void take_short_arc(const KeyRows<T>&, std::size_t) {}

template <class T>
void close(T& track, std::size_t width, float end_s, float closed_s) {
  if (track.empty() || width == 0) return;
  const KeyRows<T> keys{track, width};
  const std::vector<float>& times = track.times_s;
  const std::size_t own_last = track.key_count() - 1;
  const bool moves_at_end = own_last > 0 && times[own_last] == end_s && times[own_last - 1] < end_s;
  const bool moves_at_start = own_last > 0 && times[0] == 0.0f && times[1] > 0.0f;
  if (keys.cubic()) {
    if (moves_at_end)
      std::copy_n(keys.in_tangents(own_last), width, keys.out_tangents(own_last));
    else
      std::fill_n(keys.out_tangents(own_last), width, track.values[0] * 0.0f);
  }
  if (times[own_last] < end_s) keys.append(end_s, own_last);
  const std::size_t last = track.key_count() - 1;
  keys.append(closed_s, 0);
  if (keys.cubic() && moves_at_start) std::copy_n(keys.out_tangents(0), width, keys.in_tangents(last + 1));
  take_short_arc(keys, last);
}

}  // namespace

Result<Animation> close_loop(const Animation& animation, double gap_s) {
  if (!std::isfinite(gap_s)) return tl::unexpected(ErrorCode::not_finite);
  const float end_s = static_cast<float>(animation.duration_s);
  const float closed_s = static_cast<float>(animation.duration_s + gap_s);
  if (!(closed_s > end_s)) return tl::unexpected(ErrorCode::unsupported);
  Animation closed = animation;
  closed.duration_s = static_cast<double>(closed_s);
  for (BoneAnimation& bone : closed.bones) {
    close(bone.translation, 1, end_s, closed_s);
    close(bone.rotation, 1, end_s, closed_s);
    close(bone.scale, 1, end_s, closed_s);
  }
  for (WeightAnimation& weights : closed.weights) close(weights.weights, weights.weights.target_count, end_s, closed_s);
  for (PropertyTrack& property : closed.properties)
    close(property.values, property.values.target_count, end_s, closed_s);
  return closed;
}

}  // namespace sinew
