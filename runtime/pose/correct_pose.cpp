// SPDX-License-Identifier: MIT
#include "runtime/pose/correct_pose.h"

#include <algorithm>
#include <cassert>

#include "runtime/math/negligible.h"
#include "runtime/model/pose_basis.h"

namespace sinew {
namespace {

constexpr double kSmallestShareSum = 0.01;

void add(float& weight, double correction) noexcept {
  weight = flushed(static_cast<float>(static_cast<double>(weight) + correction));
}

/// eq   s' = clamp(s, 0, 1) / sum, where the sum is large enough
void make_partition(std::span<double> shares) noexcept {
  double sum = 0.0;
  for (double& share : shares) sum += share = std::clamp(share, 0.0, 1.0);
  const double scale = sum >= kSmallestShareSum ? 1.0 / sum : sum / (kSmallestShareSum * kSmallestShareSum);
  for (double& share : shares) share *= scale;
}

/// eq   results = basis * coefficients
void combine(const PoseCorrective& corrective, std::span<const double> basis, std::span<double> results) noexcept {
  std::fill(results.begin(), results.end(), 0.0);
  const double* row = corrective.coefficients.data();
  for (const double b : basis) {
    for (std::size_t r = 0; r < results.size(); ++r) results[r] += b * row[r];
    row += results.size();
  }
}

double mean_value(const PoseSamples& samples, std::span<const double> shares, std::size_t weight) noexcept {
  double sum = 0.0;
  for (std::size_t s = 0; s < shares.size(); ++s)
    sum += shares[s] * static_cast<double>(samples.values[s * samples.weights.size() + weight]);
  return sum;
}

}  // namespace

std::size_t scratch_size(const PoseCorrective& corrective) noexcept {
  return basis_size(corrective.samples) + corrective.result_count();
}

ErrorCode check(const CorrectPoseJob& job) noexcept {
  if (!job.corrective || job.scratch.size() < scratch_size(*job.corrective)) return ErrorCode::size_mismatch;
  if (!is_pose_of(job.pose, job.pose.joint_count) || !have_memory(job.scratch, job.weights))
    return ErrorCode::size_mismatch;
  return check(*job.corrective, job.pose.joint_count, job.weights.size());
}

void run_unchecked(const CorrectPoseJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  const PoseSamples& samples = job.corrective->samples;
  const std::size_t count = samples.sample_count(), weights = samples.weights.size();
  const std::span<double> basis = job.scratch.first(basis_size(samples));
  const std::span<double> results = job.scratch.subspan(basis.size(), job.corrective->result_count());
  std::fill(basis.begin(), basis.end(), 0.0);
  for (std::size_t d = 0; d < samples.drivers.size(); ++d)
    add_driver(samples, d, job.pose.get(samples.drivers[d].joint).rotation, basis);

  if (samples.regularisation == 0.0f)
    for (std::size_t s = 0; s < count; ++s) {
      if (basis[s] != 0.0) continue;
      for (std::size_t i = 0; i < weights; ++i)
        add(job.weights[samples.weights[i]], static_cast<double>(samples.values[s * weights + i]));
      return;
    }

  finish_basis(samples, basis);
  combine(*job.corrective, basis, results);
  if (samples.partition) make_partition(results);
  for (std::size_t i = 0; i < weights; ++i) {
    double value = samples.partition ? mean_value(samples, results, i) : results[i];
    if (samples.clamp)
      value = std::clamp(value, static_cast<double>(job.corrective->lower[i]),
                         static_cast<double>(job.corrective->upper[i]));
    add(job.weights[samples.weights[i]], value);
  }
}

}  // namespace sinew
