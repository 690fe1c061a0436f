// SPDX-License-Identifier: MIT
#include "runtime/model/pose_corrective.h"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "runtime/base/all_finite.h"
#include "runtime/model/pose_basis.h"

namespace sinew {
namespace {

constexpr double kCoincident_rad = 1e-6;
constexpr double kSmallestReciprocalCondition = 1e-10;

/// The basis functions at each sample pose.
Eigen::MatrixXd basis_at_samples(const PoseSamples& samples) {
  const std::size_t count = samples.sample_count(), drivers = samples.drivers.size();
  Eigen::MatrixXd basis =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(basis_size(samples)), static_cast<Eigen::Index>(count));
  for (std::size_t s = 0; s < count; ++s) {
    auto column = basis.col(static_cast<Eigen::Index>(s));
    for (std::size_t d = 0; d < drivers; ++d)
      add_driver(samples, d, samples.rotations[s * drivers + d], {column.data(), basis_size(samples)});
  }
  return basis;
}

bool any_coincide(const Eigen::MatrixXd& squared_distances, Eigen::Index count) {
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      if (squared_distances(j, i) < kCoincident_rad * kCoincident_rad) return true;
  return false;
}

/// The matrix of the system, [K + r I, P; P^T, 0].
Eigen::MatrixXd system_of(const Eigen::MatrixXd& basis, Eigen::Index count, double regularisation) {
  const Eigen::Index size = basis.rows();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(size, size);
  system.leftCols(count) = basis;
  system.topRows(count) = basis.transpose();
  system.diagonal().head(count).array() += regularisation;
  return system;
}

Eigen::MatrixXd wanted_at_samples(const PoseCorrective& corrective, Eigen::Index size) {
  const PoseSamples& samples = corrective.samples;
  const auto results = static_cast<Eigen::Index>(corrective.result_count());
  if (samples.partition) return Eigen::MatrixXd::Identity(size, results);
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(size, results);
  for (std::size_t i = 0; i < samples.values.size(); ++i)
    wanted(static_cast<Eigen::Index>(i) / results, static_cast<Eigen::Index>(i) % results) =
        static_cast<double>(samples.values[i]);
  return wanted;
}

void find_range(PoseCorrective& corrective) {
  const std::vector<float>& values = corrective.samples.values;
  const std::size_t count = corrective.samples.weights.size();
  corrective.lower.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
  corrective.upper = corrective.lower;
  for (std::size_t i = count; i < values.size(); ++i) {
    corrective.lower[i % count] = std::min(corrective.lower[i % count], values[i]);
    corrective.upper[i % count] = std::max(corrective.upper[i % count], values[i]);
  }
}

}  // namespace

Result<PoseCorrective> solve_corrective(PoseSamples samples) {
  if (const ErrorCode error = check(samples); error != ErrorCode::ok) return tl::unexpected(error);
  PoseCorrective corrective{std::move(samples), {}, {}, {}};
  const PoseSamples& given = corrective.samples;
  const auto count = static_cast<Eigen::Index>(given.sample_count());
  Eigen::MatrixXd basis = basis_at_samples(given);
  if (given.regularisation == 0.0f && any_coincide(basis, count)) return tl::unexpected(ErrorCode::coincident_poses);
  for (Eigen::Index s = 0; s < count; ++s)
    finish_basis(given, {basis.col(s).data(), static_cast<std::size_t>(basis.rows())});

  const Eigen::FullPivLU<Eigen::MatrixXd> lu(system_of(basis, count, static_cast<double>(given.regularisation)));
  if (!lu.isInvertible() || !(lu.rcond() >= kSmallestReciprocalCondition))
    return tl::unexpected(ErrorCode::rank_deficient);
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> solved =
      lu.solve(wanted_at_samples(corrective, basis.rows()));
  corrective.coefficients.assign(solved.data(), solved.data() + solved.size());
  find_range(corrective);
  return corrective;
}

ErrorCode check(const PoseCorrective& corrective, std::size_t joint_count, std::size_t weight_count) noexcept {
  const PoseSamples& samples = corrective.samples;
  if (const ErrorCode error = check(samples); error != ErrorCode::ok) return error;
  const std::size_t weights = samples.weights.size();
  if (corrective.coefficients.size() != basis_size(samples) * corrective.result_count())
    return ErrorCode::size_mismatch;
  if (corrective.lower.size() != weights || corrective.upper.size() != weights) return ErrorCode::size_mismatch;
  if (!all_finite(corrective.coefficients) || !all_finite(corrective.lower) || !all_finite(corrective.upper))
    return ErrorCode::not_finite;
  for (std::size_t i = 0; i < weights; ++i)
    if (corrective.lower[i] > corrective.upper[i]) return ErrorCode::unsupported;
  for (const PoseDriver& driver : samples.drivers)
    if (driver.joint >= joint_count) return ErrorCode::index_out_of_range;
  for (const std::uint32_t weight : samples.weights)
    if (weight >= weight_count) return ErrorCode::index_out_of_range;
  return ErrorCode::ok;
}

}  // namespace sinew
