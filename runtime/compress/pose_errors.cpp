// SPDX-License-Identifier: MIT
#include "runtime/compress/pose_errors.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/compress/pose_errors.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "runtime/pose/simd/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kPoses = PoseBlock::kPoses;
using Doubles = hn::CappedTag<double, kPoses>;
using Lanes = hn::Vec<Doubles>;

/// Rows of affine matrices, one pose a lane.
struct MatrixLanes {
  Lanes at[3][4];
};

HWY_INLINE MatrixLanes load(const double* numbers) {
  const Doubles d;
  MatrixLanes m;
  for (std::size_t i = 0; i < 12; ++i) m.at[i / 4][i % 4] = hn::LoadU(d, numbers + i * kPoses);
  return m;
}

HWY_INLINE void store(const MatrixLanes& m, double* numbers) {
  const Doubles d;
  for (std::size_t i = 0; i < 12; ++i) hn::StoreU(m.at[i / 4][i % 4], d, numbers + i * kPoses);
}

/// eq   affine_from_transform, operation by operation
HWY_INLINE MatrixLanes local_matrix(const PoseBlock& poses, std::size_t joint, std::size_t pose) {
  const Doubles d;
  const auto number = [&](std::size_t n) HWY_ATTR { return hn::LoadU(d, poses.number(joint, n) + pose); };
  const Lanes x = number(3), y = number(4), z = number(5), w = number(6);
  const Lanes one = hn::Set(d, 1.0), two = hn::Set(d, 2.0);
  const Lanes xx = hn::Mul(x, x), yy = hn::Mul(y, y), zz = hn::Mul(z, z);
  const Lanes xy = hn::Mul(x, y), xz = hn::Mul(x, z), yz = hn::Mul(y, z);
  const Lanes wx = hn::Mul(w, x), wy = hn::Mul(w, y), wz = hn::Mul(w, z);
  const Lanes sx = number(7), sy = number(8), sz = number(9);
  const auto on_axis = [&](Lanes a, Lanes b, Lanes scale)
                           HWY_ATTR { return hn::Mul(hn::Sub(one, hn::Mul(two, hn::Add(a, b))), scale); };
  const auto sum = [&](Lanes a, Lanes b, Lanes scale) HWY_ATTR { return hn::Mul(hn::Mul(two, hn::Add(a, b)), scale); };
  const auto difference = [&](Lanes a, Lanes b, Lanes scale)
                              HWY_ATTR { return hn::Mul(hn::Mul(two, hn::Sub(a, b)), scale); };
  return {{{on_axis(yy, zz, sx), difference(xy, wz, sy), sum(xz, wy, sz), number(0)},
           {sum(xy, wz, sx), on_axis(xx, zz, sy), difference(yz, wx, sz), number(1)},
           {difference(xz, wy, sx), sum(yz, wx, sy), on_axis(xx, yy, sz), number(2)}}};
}

HWY_INLINE MatrixLanes fixed_matrix(const Affine& matrix) {
  const Doubles d;
  MatrixLanes m;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) m.at[r][c] = hn::Set(d, static_cast<double>(matrix.row[r][c]));
  return m;
}

HWY_INLINE MatrixLanes product(const MatrixLanes& a, const MatrixLanes& b) {
  MatrixLanes out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c)
      out.at[r][c] = hn::Add(hn::Add(hn::Mul(a.at[r][0], b.at[0][c]), hn::Mul(a.at[r][1], b.at[1][c])),
                             hn::Mul(a.at[r][2], b.at[2][c]));
    out.at[r][3] = hn::Add(out.at[r][3], a.at[r][3]);
  }
  return out;
}

void compose_models(const PoseErrorsJob& job) {
  const Skeleton& skeleton = *job.skeleton;
  const std::size_t lanes = hn::Lanes(Doubles());
  for (std::size_t pose = 0; pose < job.truth.size(); pose += lanes)
    for (std::size_t j = 0; j < skeleton.joint_count(); ++j) {
      const std::uint32_t fixed = skeleton.fixed_matrix_of[j], parent = skeleton.parents[j];
      double* const models = job.models.data() + pose;
      MatrixLanes m = fixed == kNone ? local_matrix(*job.poses, j, pose) : fixed_matrix(skeleton.fixed_matrices[fixed]);
      if (parent != kNone) m = product(load(models + parent * PoseErrorsJob::kModelNumbers), m);
      store(m, models + j * PoseErrorsJob::kModelNumbers);
    }
}

/// One coordinate of the corners of a box, in the order of BoxCorners.
struct BoxLanes {
  HWY_INLINE BoxLanes(const Aabb& box, int axis) {
    const double ends[] = {static_cast<double>(box.lower[axis]), static_cast<double>(box.upper[axis])};
    for (std::size_t i = 0; i < 8; ++i) of_corner[i] = ends[i >> axis & 1];
  }
  HWY_ALIGN double of_corner[8];
};

/// The largest squared distance of a corner from its exact place.
/// eq   M c as corners_in_model
HWY_INLINE double farthest_squared(const double* model, const BoxLanes* box, const BoxCorners& truth) {
  const Doubles d;
  Lanes largest = hn::Zero(d);
  for (std::size_t corner = 0; corner < 8; corner += hn::Lanes(d)) {
    Lanes squared = hn::Zero(d);
    const Lanes x = hn::Load(d, box[0].of_corner + corner), y = hn::Load(d, box[1].of_corner + corner),
                z = hn::Load(d, box[2].of_corner + corner);
    for (std::size_t row = 0; row < 3; ++row) {
      const auto number = [&](std::size_t c) HWY_ATTR { return hn::Set(d, model[(4 * row + c) * kPoses]); };
      const Lanes plane = hn::Add(hn::Mul(number(0), x), hn::Mul(number(1), y));
      const Lanes place = hn::Add(hn::Add(plane, hn::Mul(number(2), z)), number(3));
      const Lanes away = hn::Sub(place, hn::LoadU(d, truth[row].data() + corner));
      squared = row == 0 ? hn::Mul(away, away) : hn::Add(squared, hn::Mul(away, away));
    }
    largest = hn::IfThenElse(hn::Lt(largest, squared), squared, largest);  // NaN is not larger
  }
  return hn::GetLane(hn::MaxOfLanes(d, largest));
}

void pose_errors(const PoseErrorsJob& job) {
  compose_models(job);
  for (double& worst : job.worst) worst = 0.0;
  const std::size_t joints = job.skeleton->joint_count();
  for (std::size_t j = 0; j < joints; ++j) {
    const BoxLanes box[] = {{job.boxes[j], 0}, {job.boxes[j], 1}, {job.boxes[j], 2}};
    const double* const model = job.models.data() + j * PoseErrorsJob::kModelNumbers;
    double largest = job.largest[j];
    for (std::size_t pose = 0; pose < job.truth.size(); ++pose) {
      const double squared = farthest_squared(model + pose, box, job.truth[pose][j]);
      job.squared[pose * joints + j] = squared;
      largest = largest < squared ? squared : largest;
      job.worst[pose] = job.worst[pose] < squared ? squared : job.worst[pose];
    }
    job.largest[j] = largest;
  }
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {

ErrorCode check(const PoseErrorsJob& job) noexcept {
  if (!job.skeleton || !job.poses) return ErrorCode::size_mismatch;
  const std::size_t joints = job.skeleton->joint_count();
  const bool fits =
      job.boxes.size() == joints && job.poses->joint_count() == joints && job.truth.size() <= PoseBlock::kPoses &&
      job.models.size() >= joints * PoseErrorsJob::kModelNumbers && job.squared.size() >= job.truth.size() * joints &&
      job.largest.size() == joints && job.worst.size() == job.truth.size();
  return fits ? ErrorCode::ok : ErrorCode::size_mismatch;
}

SINEW_DISPATCH_RUN(PoseErrorsJob, pose_errors)

}  // namespace sinew
#endif  // HWY_ONCE
