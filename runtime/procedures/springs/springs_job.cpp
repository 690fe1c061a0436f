// SPDX-License-Identifier: MIT
#include "runtime/procedures/springs/springs_job.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "runtime/base/same_bits.h"
#include "runtime/pose/exact_joint.h"
#include "runtime/procedures/springs/spring_ticks.h"

namespace sinew {
namespace {

using namespace springs;

constexpr double kRounding = 1e-6;  ///< part of a tick by which rounded sums of frame times may miss a tick's end
constexpr double kFarthest = 8.0;   ///< most frames by which transforms are extrapolated

/// Simulates one frame of one character.
class SpringsFrame {
 public:
  explicit SpringsFrame(const SpringsJob& job) noexcept
      : job_(job),
        tables_(job.springs->tables()),
        settings_(job.springs->settings()),
        memory_(tables_, job.state.data(), job.scratch.data()),
        clock_(*memory_.clock) {}

  void run() noexcept {
    const bool joints_changed = read_joints();
    const bool changed = read_frames() || joints_changed;
    if (clock_.started == 0 || job_.event == SpringEvent::reset) {
      start();
    } else if (job_.event == SpringEvent::teleport) {
      teleport();
    }
    if (clock_.asleep != 0 && (changed || job_.event != SpringEvent::none)) wake();
    if (clock_.asleep == 0 || !job_.tails.empty()) {
      step(changed);
    }
    write();
    std::copy(memory_.before.begin(), memory_.before.end(), memory_.earlier.begin());
    std::copy(memory_.now.begin(), memory_.now.end(), memory_.before.begin());
    clock_.before_s = starts_ || job_.event == SpringEvent::teleport ? 0.0 : job_.dt_s;
    clock_.root = job_.root;
    counts_.asleep = clock_.asleep != 0;
    if (job_.counts) *job_.counts = counts_;
  }

 private:
  /// Reads the local transforms of all joints. Returns true if one differs from the previous frame.
  bool read_joints() noexcept {
    const bool was_at_rest = clock_.at_rest != 0;
    clock_.at_rest = is_at_rest() ? 1 : 0;
    if (clock_.at_rest != 0) {
      inputs_ = {tables_.slots.rest_inputs.data(), tables_.slots.stride};
      is_uniform_ = tables_.is_rest_uniform;
      return !was_at_rest;
    }
    bool changed = was_at_rest;
    for (std::size_t r = 0; r < tables_.records.size(); ++r) {
      const SpringRecord& record = tables_.records[r];
      Transform local = job_.pose.get(record.joint);
      if (record.goal == SpringGoal::rest) local.rotation = quat_identity<float>();  // animation is ignored
      changed |= !same_bits(local, memory_.read[r]);
      memory_.read[r] = local;
      is_uniform_ &= scales_evenly(local);
      place(joint_input(record, local), memory_.inputs.data, memory_.inputs.stride, tables_.slots.slot[r]);
    }
    inputs_ = {memory_.inputs.data, memory_.inputs.stride};
    return changed;
  }

  /// True if all joints have the bits of their rest transforms. Rotations that springs ignore do not count.
  bool is_at_rest() const noexcept {
    const std::size_t records = tables_.records.size();
    for (const SpringRun& run : tables_.runs)
      for (std::size_t p = 0; p < PoseSpan::plane_count; ++p) {
        if (p >= PoseSpan::rx && p <= PoseSpan::rw && !run.reads_rotations) continue;
        if (std::memcmp(job_.pose.planes + p * job_.pose.stride + run.joint, &tables_.rest[p * records + run.record],
                        run.count * sizeof(float)) != 0)
          return false;
      }
    return true;
  }

  /// Computes the world transforms of the joints that springs hang on. Returns true if one differs from the previous
  /// frame.
  bool read_frames() noexcept {
    for (std::size_t a = 0; a < tables_.ancestors.size(); ++a) {
      const SpringAncestor& ancestor = tables_.ancestors[a];
      const Affined& above = ancestor.parent == kNone ? job_.root : memory_.ancestors[ancestor.parent];
      memory_.ancestors[a] = above * exact_local_matrix(*job_.skeleton, job_.pose, ancestor.joint);
    }
    bool changed = false;
    for (std::size_t f = 0; f < tables_.frames.size(); ++f) {
      const std::uint32_t ancestor = tables_.frames[f].ancestor;
      memory_.now[f] = input_frame_of(ancestor == kNone ? job_.root : memory_.ancestors[ancestor]);
      changed |= memory_.now[f] != memory_.before[f];
      is_uniform_ &= is_uniform(memory_.now[f]) &&
                     (clock_.started == 0 || (is_uniform(memory_.before[f]) && is_uniform(memory_.earlier[f])));
    }
    return changed;
  }

  void start() noexcept {
    clock_ = {.left_s = 0.0,
              .before_s = 0.0,
              .started = 1,
              .asleep = 0,
              .at_rest = clock_.at_rest,
              .quiet_ticks = 0,
              .sleeps = clock_.sleeps,
              .root = job_.root};
    std::copy(memory_.now.begin(), memory_.now.end(), memory_.before.begin());
    starts_ = true;
  }

  /// Moves tails rigidly with the input frame of their chain. Tails in the space of a centre move with the centre
  /// anyway.
  void teleport() noexcept {
    for (std::size_t r = 0; r < tables_.records.size(); ++r) {
      const SpringRecord& record = tables_.records[r];
      if (record.group == kNone || tables_.groups[record.group].center != kNone) continue;
      const InputFrame &from = memory_.before[record.frame], &to = memory_.now[record.frame];
      const Rot turn = to.rotation * quat_conjugate(from.rotation);
      for (const std::size_t plane : {tail::now, tail::before}) {
        double* x = &memory_.tails.at(plane, tables_.slots.slot[r]);
        const std::size_t y = memory_.tails.stride, z = 2 * y;
        const Vec moved = to.at + rotate_vector(turn, Vec(x[0], x[y], x[z]) - from.at);
        x[0] = moved.x;
        x[y] = moved.y;
        x[z] = moved.z;
      }
    }
    std::copy(memory_.now.begin(), memory_.now.end(), memory_.before.begin());
  }

  void wake() noexcept {
    clock_.asleep = 0;
    clock_.quiet_ticks = 0;
  }

  void step(bool changed) noexcept {
    const bool was_asleep = clock_.asleep != 0;
    const double h = settings_.tick_s, quiet = settings_.sleep_rad_per_s * h;
    const Ticks ticks{tables_, memory_, inputs_, is_uniform_};
    if (starts_) {
      place_inputs(ticks, {});
      reset_tails(ticks);
    } else if (clock_.asleep == 0) {
      advance(ticks, quiet * quiet, changed);
    }
    if (!is_shown_) show(ticks);
    if (!was_asleep) keep_rotations();
    if (!job_.tails.empty()) write_tails();
  }

  /// Shows the time at the end of the frame, which may lie between two ticks.
  void show(const Ticks& ticks) noexcept {
    const double h = settings_.tick_s;
    const double left = clock_.left_s > h * kRounding ? clock_.left_s : 0.0;
    if (left > 0.0) {  // the frame lies between two ticks: computes the next tick to interpolate
      const double ahead = job_.dt_s > 0.0 ? (std::min)((h - left) / job_.dt_s, kFarthest) : 0.0;
      place_inputs(ticks, weights_at(1.0 + ahead, job_.dt_s, 0.0));
      run_tick(ticks, 0.0, false);
      count_tick();
    }
    place_inputs(ticks, {});
    show_tails(ticks, left / h);
  }

  void advance(const Ticks& ticks, double threshold, bool changed) noexcept {
    const double h = settings_.tick_s;
    clock_.left_s += job_.dt_s;
    const double due = std::floor(clock_.left_s / h + kRounding), most = settings_.max_ticks;
    if (due > most) {
      // Rounding of a very long frame time could be longer than a tick.
      clock_.left_s = std::clamp(clock_.left_s - (due - most) * h, (most - kRounding) * h, (most + 1.0) * h);
      counts_.dropped_ticks = static_cast<std::uint32_t>((std::min)(due - most, 4e9));
    }
    for (double left = (std::min)(due, most); left > 0.0 && clock_.asleep == 0; left -= 1.0) {
      clock_.left_s -= h;
      const double after = clock_.left_s > h * kRounding ? clock_.left_s : 0.0;
      const double fraction = job_.dt_s > 0.0 ? (std::max)(1.0 - after / job_.dt_s, 0.0) : 1.0;
      place_inputs(ticks, weights_at(fraction, job_.dt_s, clock_.before_s));
      is_shown_ = after == 0.0 && left == 1.0;  // this last tick ends with the frame and also writes the rotations
      const bool moves = run_tick(ticks, threshold, is_shown_);
      commit_tick(ticks);
      count_tick();
      clock_.quiet_ticks = moves || changed ? 0 : clock_.quiet_ticks + 1;
      if (settings_.sleep_rad_per_s > 0.0 && clock_.quiet_ticks >= settings_.sleep_ticks) fall_asleep();
    }
  }

  void fall_asleep() noexcept {
    clock_.asleep = 1;
    clock_.left_s = 0.0;
    ++clock_.sleeps;
    std::copy_n(memory_.tails.plane(tail::now), 3 * memory_.tails.stride, memory_.tails.plane(tail::before));
  }

  void count_tick() noexcept {
    ++counts_.ticks;
    counts_.joints += static_cast<std::uint32_t>(tables_.records.size());
  }

  /// Brings the rotations of the last tick from slots to the order of the skeleton. Sleeping springs keep these bits.
  void keep_rotations() noexcept {
    const std::size_t records = tables_.records.size();
    for (std::size_t p = 0; p < 4; ++p) {
      const double* shown = memory_.shown.plane(shown::rotation + p);
      float* written = &memory_.written[p * records];
      for (std::size_t r = 0; r < records; ++r) written[r] = static_cast<float>(shown[tables_.slots.slot[r]]);
    }
  }

  void write_tails() const noexcept {
    for (std::size_t r = 0; r < tables_.records.size(); ++r) {
      const std::size_t slot = tables_.slots.slot[r];
      const auto at = [&](std::size_t axis) { return memory_.shown.at(shown::end + axis, slot); };
      if (tables_.records[r].setup != kNone) job_.tails[tables_.records[r].setup] = {at(0), at(1), at(2)};
    }
  }

  void write() const noexcept {
    for (const SpringRun& run : tables_.runs) {
      if (!run.writes_rotations) continue;
      if (job_.weight != 1.0f) {
        for (std::size_t i = 0; i < run.count; ++i) mix(run.joint + i, run.record + i);
        continue;
      }
      for (std::size_t p = 0; p < 4; ++p)
        std::copy_n(&memory_.written[p * tables_.records.size() + run.record], run.count,
                    job_.pose.planes + (PoseSpan::rx + p) * job_.pose.stride + run.joint);
    }
  }

  /// Turns a joint a part of the way from the pose to its spring.
  void mix(std::size_t joint, std::size_t record) const noexcept {
    const auto at = [&](std::size_t p) {
      return static_cast<double>(memory_.written[p * tables_.records.size() + record]);
    };
    const double weight = static_cast<double>(job_.weight);
    const Rot pose = quat_cast<double>(job_.pose.get(joint).rotation);
    const Rot rotation = aligned_with(pose, quat_xyzw(at(0), at(1), at(2), at(3)));
    job_.pose.set_rotation(joint, quat_cast<float>(normalised_or(pose * (1.0 - weight) + rotation * weight, pose)));
  }

  const SpringsJob& job_;
  const SpringTables& tables_;
  const SpringSettings& settings_;
  SpringMemory memory_;
  Clock& clock_;
  Planes<const double> inputs_;  ///< in scratch, or SpringSlots::rest_inputs
  SpringCounts counts_;
  bool is_uniform_ = true, starts_ = false, is_shown_ = false;
};

bool is_aligned(std::span<const std::byte> memory) noexcept {
  return reinterpret_cast<std::uintptr_t>(memory.data()) % 8 == 0;
}

bool overlap(std::span<const std::byte> a, std::span<const std::byte> b) noexcept {
  return a.data() < b.data() + b.size() && b.data() < a.data() + a.size();
}

}  // namespace

ErrorCode check(const SpringsJob& job) noexcept {
  if (!job.springs || !job.skeleton) return ErrorCode::size_mismatch;
  const std::size_t joints = job.springs->skeleton_joint_count();
  if (job.skeleton->joint_count() != joints || !is_pose_of(job.pose, joints)) return ErrorCode::size_mismatch;
  if (!have_memory(job.state, job.scratch, job.tails) || !is_aligned(job.state) || !is_aligned(job.scratch))
    return ErrorCode::size_mismatch;
  if (job.state.size() < job.springs->state_bytes() || job.scratch.size() < job.springs->scratch_bytes())
    return ErrorCode::size_mismatch;
  if (!job.tails.empty() && job.tails.size() < job.springs->joint_count()) return ErrorCode::size_mismatch;
  const std::span<const std::byte> pose{reinterpret_cast<const std::byte*>(job.pose.planes),
                                        PoseSpan::plane_count * job.pose.stride * sizeof(float)};
  if (overlap(job.state, job.scratch) || overlap(job.state, pose) || overlap(job.scratch, pose))
    return ErrorCode::overlapping_buffers;
  for (const auto& row : job.root.row)
    for (int c = 0; c < 4; ++c)
      if (!std::isfinite(row[c])) return ErrorCode::not_finite;
  if (!std::isfinite(job.dt_s)) return ErrorCode::not_finite;
  if (job.dt_s < 0.0) return ErrorCode::times_not_increasing;
  return job.weight >= 0.0f && job.weight <= 1.0f ? ErrorCode::ok : ErrorCode::not_a_fraction;
}

void run_unchecked(const SpringsJob& job) noexcept {
  if (!job.springs->tables().records.empty()) {
    SpringsFrame(job).run();
  } else if (job.counts) {
    *job.counts = {};
  }
}

bool springs_asleep(std::span<const std::byte> state, const Affined& root) noexcept {
  if (state.size() < sizeof(Clock)) return false;
  const Clock& clock = *reinterpret_cast<const Clock*>(state.data());
  return clock.asleep != 0 && same_bits(clock.root, root);
}

std::uint64_t springs_sleeps(std::span<const std::byte> state) noexcept {
  return state.size() < sizeof(Clock) ? 0 : reinterpret_cast<const Clock*>(state.data())->sleeps;
}

}  // namespace sinew
