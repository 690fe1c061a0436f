// SPDX-License-Identifier: MIT
#include <string>

#include "runtime/playback/playback_clock.h"
#include "runtime/pose/local_to_model.h"
#include "samples/where_float_ends/rows.h"

namespace sinew::sample {
namespace {

constexpr const char* kPart = "poses";

/// The error of the tip of a chain of joints of 10 cm, each turned a little relative to its parent.
Row chain_row(std::uint32_t joints, double bound) {
  Skeleton skeleton;
  for (std::uint32_t j = 0; j < joints; ++j) {
    skeleton.parents.push_back(j == 0 ? kNone : j - 1);
    skeleton.level_begin.push_back(j);
  }
  skeleton.level_begin.push_back(joints);
  skeleton.rest.resize(joints);
  skeleton.names.resize(joints);
  skeleton.fixed_matrix_of.assign(joints, kNone);
  struct alignas(64) Block {
    float floats[16];
  };
  std::vector<Block> memory(PoseSpan::floats_for(joints) / 16 + 1);
  const PoseSpan pose = pose_over({memory[0].floats, PoseSpan::floats_for(joints)}, joints);
  std::vector<Affine> model(joints);
  Sweep sweep;
  Largest largest;
  for (int i = 0; i < 40; ++i) {
    Affined tip;
    for (std::uint32_t j = 0; j < joints; ++j) {
      const Quat<float> q = quat_cast<float>(sweep.turn(sweep.in(0, 20) * kDegree));
      const Transform local{{0, 0.1f, 0}, q, {1, 1, 1}};
      pose.set(j, local);
      tip = tip * affine_from_transform(
                      Transformd{Vec3<double>(local.translation), normalised(quat_cast<double>(q)), Vec3<double>(1)});
    }
    run_unchecked(LocalToModelJob{&skeleton, pose, {}, model});
    largest.add_place(translation_of(model.back()), translation_of(tip));
  }
  return largest.row(kPart, "tip of a chain of 10 cm joints", std::to_string(joints) + " joints", "m", bound);
}

/// The error of a point of a character far from the origin. It is placed by its world matrix in float, or relative to a
/// root that is added in double.
Row far_row(double distance, bool relative, double bound) {
  Sweep sweep;
  Largest largest;
  for (int i = 0; i < 2000; ++i) {
    const Vec3<double> root = sweep.direction() * distance;
    const Transformd local{Vec3<double>(sweep.direction()), as_stored(sweep.rotation()), Vec3<double>(1)};
    const Vec3<float> p(sweep.direction());
    const Affined placed = affine_from(Mat3<double>(1), root) * affine_from_transform(local);
    const Vec3<double> truth = transform_point(placed, Vec3<double>(p));
    if (relative) {
      const Vec3<float> near = transform_point(affine_cast<float>(affine_from_transform(local)), p);
      largest.add_place(near, truth - root);
    } else {
      largest.add_place(transform_point(affine_cast<float>(placed), p), truth);
    }
  }
  return largest.row(kPart, relative ? "vertex relative to its root" : "vertex in world coordinates",
                     std::to_string(static_cast<int>(distance / 1000)) + " km out", "m", bound);
}

/// The error of the clock after hours of frames of 1/60 s, compared with the exact sum.
Row clock_row(bool in_float, int hours, double bound) {
  const double duration_s = 1e6, dt_s = 1.0 / 60;
  const long frames = 3600L * 60 * hours;
  const long double truth = static_cast<long double>(dt_s) * frames;
  float sum_s = 0.0f;
  PlaybackClock clock(duration_s, PlayMode::once);
  double shown_s = 0.0;
  for (long i = 0; i < frames; ++i) {
    if (in_float)
      sum_s += static_cast<float>(dt_s);
    else
      shown_s = clock.advance(dt_s).to_s;
  }
  Largest largest;
  const double found = in_float ? static_cast<double>(sum_s) : shown_s;
  const float size = static_cast<float>(truth);
  largest.add(std::abs(static_cast<double>(static_cast<long double>(found) - truth)),
              static_cast<double>(std::nextafter(size, INFINITY) - size));
  return largest.row(kPart, in_float ? "seconds summed in float" : "seconds of PlaybackClock",
                     "frames of 1/60 s, " + std::to_string(hours) + " h", "s", bound);
}

/// The error of the time of a frame in one float: up to half a float step.
Row time_row(int hours, double bound) {
  Sweep sweep;
  Largest largest;
  for (int i = 0; i < 2000; ++i) {
    const double t = 3600.0 * hours + sweep.in(0, 10);
    const float stored = static_cast<float>(t);
    largest.add(std::abs(static_cast<double>(stored) - t),
                static_cast<double>(std::nextafter(stored, INFINITY) - stored));
  }
  return largest.row(kPart, "one time held in float", "after " + std::to_string(hours) + " h", "s", bound);
}

}  // namespace

void add_pose_rows(Rows& rows) {
  rows.push_back(chain_row(64, 2e-5));
  rows.push_back(chain_row(1000, 3e-4));
  for (const double distance : {1e3, 1e4}) {
    rows.push_back(far_row(distance, false, distance * 1.5e-7));
    rows.push_back(far_row(distance, true, 1e-6));
  }
  for (const int hours : {1, 10}) {
    rows.push_back(time_row(hours, hours == 1 ? 1.3e-4 : 2e-3));
    rows.push_back(clock_row(true, hours, hours == 1 ? 4 : 2000));
    rows.push_back(clock_row(false, hours, 1e-11));
  }
}

}  // namespace sinew::sample
