// SPDX-License-Identifier: MIT
#include "runtime/model/pose_samples.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "runtime/base/all_finite.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

template <class V>
bool has_direction(const V& v) noexcept {
  return largest_component(v) > 0.0f && std::isfinite(square_of(v / largest_component(v)));
}

ErrorCode check_drivers(const PoseSamples& samples) noexcept {
  float total = 0.0f;
  for (const PoseDriver& driver : samples.drivers) {
    if (!std::isfinite(driver.weight) || !has_direction(driver.axis)) return ErrorCode::not_finite;
    if (driver.weight < 0.0f) return ErrorCode::unsupported;
    total += driver.weight;
  }
  return total > 0.0f && std::isfinite(total) ? ErrorCode::ok : ErrorCode::not_finite;
}

}  // namespace

ErrorCode check(const PoseSamples& samples) noexcept {
  const std::size_t count = samples.sample_count();
  if (count == 0 || samples.weights.empty()) return ErrorCode::size_mismatch;
  if (samples.rotations.size() != count * samples.drivers.size()) return ErrorCode::size_mismatch;
  if (samples.values.size() != count * samples.weights.size()) return ErrorCode::size_mismatch;
  if (const ErrorCode error = check_drivers(samples); error != ErrorCode::ok) return error;
  if (!std::all_of(samples.rotations.begin(), samples.rotations.end(), has_direction<glm::quat>))
    return ErrorCode::not_finite;
  if (!all_finite(samples.values) || !std::isfinite(samples.radius_rad) || !std::isfinite(samples.regularisation))
    return ErrorCode::not_finite;
  return samples.radius_rad > 0.0f && samples.regularisation >= 0.0f ? ErrorCode::ok : ErrorCode::unsupported;
}

}  // namespace sinew
