// SPDX-License-Identifier: MIT
#include "runtime/procedures/springs/springs_job.h"

#include <algorithm>
#include <cmath>

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
      if (is_uniform_)
        step<UniformFrame>(changed);
      else
        step<MatrixFrame>(changed);
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
      inputs_ = tables_.rest_inputs;
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
      memory_.inputs[r] = joint_input(record, local);
    }
    inputs_ = memory_.inputs;
    return changed;
  }

  /// True if all joints have their rest transforms. Rotations that springs ignore do not count.
  bool is_at_rest() const noexcept {
    for (std::size_t r = 0; r < tables_.records.size(); ++r) {
      const SpringRecord& record = tables_.records[r];
      const Transform local = job_.pose.get(record.joint);
      const Transform& rest = tables_.rest[r];
      if (local.translation != rest.translation || local.scale != rest.scale) return false;
      if (record.goal == SpringGoal::pose && local.rotation != rest.rotation) return false;
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
      for (Vec* tail : {&memory_.tails[r].now, &memory_.tails[r].before})
        *tail = to.at + rotate_vector(turn, *tail - from.at);
    }
    std::copy(memory_.now.begin(), memory_.now.end(), memory_.before.begin());
  }

  void wake() noexcept {
    clock_.asleep = 0;
    clock_.quiet_ticks = 0;
  }

  template <class Frame>
  void step(bool changed) noexcept {
    const bool was_asleep = clock_.asleep != 0;
    const double h = settings_.tick_s, quiet = settings_.sleep_rad_per_s * h;
    Ticks<Frame> ticks(tables_, memory_, inputs_, quiet * quiet);
    if (starts_) {
      ticks.place_inputs({});
      ticks.reset();
    } else if (clock_.asleep == 0) {
      advance(ticks, changed);
    }
    if (is_shown_) return;
    const double left = clock_.left_s > h * kRounding ? clock_.left_s : 0.0;
    if (left > 0.0) {  // the frame lies between two ticks: computes the next tick to interpolate
      const double ahead = job_.dt_s > 0.0 ? (std::min)((h - left) / job_.dt_s, kFarthest) : 0.0;
      ticks.place_inputs(weights_at(1.0 + ahead, job_.dt_s, 0.0));
      ticks.template tick<false>();
      count_tick();
    }
    ticks.place_inputs({});
    ticks.show(left / h, job_.tails, !was_asleep);
  }

  template <class Frame>
  void advance(Ticks<Frame>& ticks, bool changed) noexcept {
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
      ticks.place_inputs(weights_at(fraction, job_.dt_s, clock_.before_s));
      is_shown_ = after == 0.0 && left == 1.0;  // this last tick ends with the frame and also writes the rotations
      const bool moves = is_shown_ ? ticks.template tick<true>(job_.tails) : ticks.template tick<false>();
      ticks.commit();
      count_tick();
      clock_.quiet_ticks = moves || changed ? 0 : clock_.quiet_ticks + 1;
      if (settings_.sleep_rad_per_s > 0.0 && clock_.quiet_ticks >= settings_.sleep_ticks) fall_asleep();
    }
  }

  void fall_asleep() noexcept {
    clock_.asleep = 1;
    clock_.left_s = 0.0;
    ++clock_.sleeps;
    for (Tail& tail : memory_.tails) tail.before = tail.now;
  }

  void count_tick() noexcept {
    ++counts_.ticks;
    counts_.joints += static_cast<std::uint32_t>(tables_.records.size());
  }

  void write() const noexcept {
    for (std::size_t r = 0; r < tables_.records.size(); ++r) {
      const SpringRecord& record = tables_.records[r];
      if (record.setup == kNone) continue;
      Rot rotation = memory_.shown[r];
      if (job_.weight != 1.0f) {
        const Rot pose = quat_cast<double>(job_.pose.get(record.joint).rotation);
        const double weight = static_cast<double>(job_.weight);
        rotation = normalised_or(pose * (1.0 - weight) + aligned_with(pose, rotation) * weight, pose);
      }
      job_.pose.set_rotation(record.joint, quat_cast<float>(rotation));
    }
  }

  const SpringsJob& job_;
  const SpringTables& tables_;
  const SpringSettings& settings_;
  SpringMemory memory_;
  Clock& clock_;
  std::span<const JointInput> inputs_;  ///< [records] in scratch, or SpringTables::rest_inputs
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
