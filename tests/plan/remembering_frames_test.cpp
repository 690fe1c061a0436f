// SPDX-License-Identifier: MIT
// Frames reuse unchanged results of earlier frames. After any sequence of inputs each frame must have the bits of a
// fresh buffer that saw only the last input. The since_frame numbers must tell what really changed.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <map>
#include <optional>

#include "runtime/plan/run_plan.h"
#include "tests/plan/frame_equality.h"
#include "tests/plan/reference_held_input.h"

namespace sinew::test {
namespace {

/// One random seed a frame.
using Steps = std::vector<std::uint32_t>;

rc::Gen<Steps> some_steps() { return rc::gen::resize(200, rc::gen::arbitrary<Steps>()); }

/// Hash of everything that determines the vertices of an instance: joints, morph weights, winding and a played vertex
/// source. 0 = unknown, because the plan does not output joints or weights, or because the source is late.
std::uint64_t causes_of(const Plan& plan, const FrameResult& result, std::uint32_t i, const FrameInput& input) {
  const Scene& scene = plan.scene();
  const std::uint32_t skin = scene.instances[i].skin, first = scene.first_weight[i];
  const bool known =
      (skin == kNone || plan.needs().out.palettes) && plan.needs().out.weights && plan.needs().out.joints;
  if (!known || result.instances[i].late) return 0;
  const std::array<std::uint32_t, 1> winding = {result.instances[i].mirrored};
  BitHash hash;
  hash.add(std::span(winding)).add(result.weights.subspan(first, scene.first_weight[i + 1] - first));
  if (skin != kNone) hash.add(result.palettes[skin].matrices);
  const std::vector<std::uint32_t>& cached = plan.needs().in.cached_instances;
  const auto slot = static_cast<std::size_t>(std::ranges::find(cached, i) - cached.begin());
  if (slot == cached.size() || input.geometry.empty() || !input.geometry[slot].plays()) return hash.value();
  const GeometryInput& geometry = input.geometry[slot];
  const std::array<std::uint64_t, 4> played = {geometry.source.content, std::uint64_t(geometry.source.space),
                                               std::bit_cast<std::uint64_t>(geometry.time_s),
                                               std::bit_cast<std::uint32_t>(geometry.weight)};
  return hash.add(std::span(played)).add(result.model).add(std::span(&input.root, 1)).value();
}

/// Checks the since_frame numbers of results against the history of all earlier frames.
class StampHistory {
 public:
  explicit StampHistory(const Plan& plan) : plan_(plan), row_(plan.primitives().size()), hash_of_frame_(row_.size()) {}

  /// in   same_input   the character's last frame had this input, too
  void check(const FrameResult& now, const FrameInput& input, bool same_input) {
    RC_ASSERT(now.since_frame == (same_input ? last_since_ : now.frame));
    last_since_ = now.since_frame;
    for (std::size_t p = 0; p < now.primitives.size(); ++p) {
      check_shape(p, now.primitives[p], now.frame, same_input);
      check_row(row_[p], now, now.primitives[p], input);
    }
    for (std::size_t s = 0; s < now.palettes.size(); ++s) check_palette(s, now.palettes[s], now.frame);
  }

 private:
  /// The latest frames in a row whose vertices have the same causes.
  struct Row {
    std::uint64_t causes = 0, first_frame = 0;
  };

  /// since_frame must not change while the causes stay the same.
  void check_row(Row& row, const FrameResult& now, const DeformedPrimitive& shape, const FrameInput& input) const {
    const std::uint64_t causes = shape.since_frame == 0 ? 0 : causes_of(plan_, now, shape.instance, input);
    if (causes == 0 || causes != row.causes) row = {causes, now.frame};
    RC_ASSERT(shape.since_frame <= row.first_frame);
  }

  struct Palette {
    std::vector<JointMatrix> matrices;
    std::uint64_t since_frame = 0;
  };

  /// A shape must have kept its bits since since_frame, and a repeated input must not change since_frame.
  void check_shape(std::size_t p, const DeformedPrimitive& shape, std::uint64_t frame, bool same_input) {
    std::map<std::uint64_t, std::uint64_t>& hashes = hash_of_frame_[p];
    if (same_input) RC_ASSERT(shape.since_frame == since_of_shape_[p]);
    since_of_shape_[p] = shape.since_frame;
    if (shape.since_frame == 0) return;
    RC_ASSERT(shape.since_frame <= frame);
    const std::uint64_t hash = hashes[frame] = hash_shape(shape);
    for (auto seen = hashes.lower_bound(shape.since_frame); seen != hashes.end(); ++seen)
      RC_ASSERT(seen->second == hash);
  }

  /// A palette's since_frame must be the first of the latest frames in a row with these bits.
  void check_palette(std::size_t s, const SkinPalette& palette, std::uint64_t frame) {
    Palette& last = palettes_[s];
    const bool unchanged = last.since_frame != 0 && same_bits<JointMatrix>(palette.matrices, last.matrices);
    const std::uint64_t expected = palette.matrices.empty() ? 0 : unchanged ? last.since_frame : frame;
    RC_ASSERT(palette.since_frame == expected);
    last = {{palette.matrices.begin(), palette.matrices.end()}, palette.since_frame};
  }

  Plan plan_;
  std::vector<Row> row_;                                               // [primitives]
  std::vector<std::map<std::uint64_t, std::uint64_t>> hash_of_frame_;  // [primitives]
  std::map<std::size_t, std::uint64_t> since_of_shape_;
  std::map<std::size_t, Palette> palettes_;
  std::uint64_t last_since_ = 0;
};

/// A character that shows a scene by several plans in turn. The plans share the same blocks of memory.
class Character {
 public:
  Character(std::uint64_t seed, std::size_t plan_count, std::size_t buffer_count) : scene_(busy_scene(seed)) {
    for (std::size_t p = 0; p < plan_count; ++p) plans_.push_back(compile_plan(lend(scene_), needs(seed + p, p)));
    std::size_t most = 0;
    for (const Plan& plan : plans_) most = std::max(most, plan.frame_bytes());
    for (std::size_t b = 0; b < buffer_count; ++b)
      blocks_.emplace_back((most + FrameBuffer::kAlignment) / sizeof(Line));
    take_plan(0);
  }

  void step(std::uint32_t seed) {
    FixedRandom random(std::uint64_t{seed} + 77);
    if (plans_.size() > 1 && random.below(8) == 0) take_plan(random.below(static_cast<std::uint32_t>(plans_.size())));
    inputs_->step(seed);
    const std::size_t next = random.below(static_cast<std::uint32_t>(buffers_.size()));
    if (random.below(16) == 0) refuse(next);
    run(next);
  }

 private:
  struct alignas(FrameBuffer::kAlignment) Line {
    std::byte bytes[FrameBuffer::kAlignment];
  };

  /// Plans with an even index have all joints, other plans leave some out.
  Needs needs(std::uint64_t seed, std::size_t plan) const {
    Needs needs = busy_needs(seed, scene_);
    if (plan % 2 == 0) return needs;
    needs.out.skeleton_lod.kept.assign(scene_.skeleton.joint_count(), true);
    for (std::size_t j = scene_.skeleton.joint_count() * 2 / 3; j < scene_.skeleton.joint_count(); ++j)
      needs.out.skeleton_lod.kept[j] = false;
    return needs;
  }

  /// Makes new buffers over the memory in which the last plan's data still lies.
  void take_plan(std::size_t plan) {
    plan_ = plans_[plan];
    buffers_.clear();
    for (std::vector<Line>& block : blocks_) buffers_.emplace_back(plan_, std::as_writable_bytes(std::span(block)));
    inputs_.emplace(plan_);
    last_inputs_.reset();
    has_run_ = false;
    stamps_.emplace(plan_);
  }

  /// A refused input must leave the last good frame unchanged.
  void refuse(std::size_t buffer) {
    const ClipLayer none{.clip = 1000};
    FrameInput bad = inputs_->view();
    bad.layers = {&none, 1};
    FrameBuffer& frame = buffers_[buffer];
    const FrameResult& result = frame.result();
    const std::uint64_t number = result.frame, since = result.since_frame;
    std::vector<std::uint64_t> before;
    for (const DeformedPrimitive& shape : result.primitives) before.push_back(hash_shape(shape));
    RC_ASSERT(run_plan(plan_, bad, frame) == ErrorCode::index_out_of_range);
    RC_ASSERT(result.frame == number);
    RC_ASSERT(result.since_frame == since);
    for (std::size_t p = 0; p < before.size(); ++p) RC_ASSERT(hash_shape(result.primitives[p]) == before[p]);
  }

  /// True if the frame keeps this input. It cannot keep more layers than the plan has room for.
  bool is_remembered(const FrameInput& input) const {
    const std::size_t room = plan_.needs().in.layer_room();
    return input.asleep ||
           (input.layers.size() <= room && (input.interpolation_factor == 0.0f || input.next_layers.size() <= room));
  }

  void run(std::size_t next) {
    FrameBuffer& frame = buffers_[next];
    frame.write_past_caches(number_ % 3 == 0);
    frame.count_from(number_++);
    if (has_run_ && next != at_) frame.follow(buffers_[at_]);
    has_run_ = true;
    at_ = next;
    const FrameInput input = inputs_->view();
    RC_ASSERT(run_plan(plan_, input, frame) == ErrorCode::ok);
    FrameBuffer fresh(plan_);
    RC_ASSERT(run_plan(plan_, inputs_->without_pages().view(), fresh) == ErrorCode::ok);
    RC_ASSERT(first_difference(frame.result(), fresh.result()) == "");
    RC_ASSERT(holds_result_of(frame, input) == (is_remembered(input) && !is_late(frame.result())));
    stamps_->check(frame.result(), input,
                   last_inputs_ && is_remembered(input) && means_the_same(*last_inputs_, *inputs_));
    last_inputs_ = inputs_;
    if (is_late(frame.result())) last_inputs_.reset();  // the next frame may show more without a change of input
  }

  static bool is_late(const FrameResult& result) {
    return std::any_of(result.instances.begin(), result.instances.end(), [](const auto& i) { return i.late; });
  }

  Scene scene_;
  std::vector<Plan> plans_;
  std::vector<std::vector<Line>> blocks_;
  Plan plan_;
  std::vector<FrameBuffer> buffers_;
  std::optional<RandomInputs> inputs_, last_inputs_;
  std::optional<StampHistory> stamps_;
  std::uint64_t number_ = 0;
  std::size_t at_ = 0;
  bool has_run_ = false;
};

RC_GTEST_PROP(remembering_frames, P19_one_buffer_remembers_rightly, (std::uint64_t seed)) {
  const Steps steps = *some_steps();
  Character character(seed, 1, 1);
  for (const std::uint32_t step : steps) character.step(step);
}

RC_GTEST_PROP(remembering_frames, P19_buffers_that_take_turns_remember_rightly, (std::uint64_t seed)) {
  const Steps steps = *some_steps();
  Character character(seed, 1, 3);
  for (const std::uint32_t step : steps) character.step(step);
}

RC_GTEST_PROP(remembering_frames, P19_plans_that_take_turns_in_one_memory_remember_rightly, (std::uint64_t seed)) {
  const Steps steps = *some_steps();
  Character character(seed, 3, 2);
  for (const std::uint32_t step : steps) character.step(step);
}

/// A character with held inputs and several buffers in turn, shown by one of two plans.
class HeldCharacter {
 public:
  explicit HeldCharacter(std::uint64_t seed) : scene_(busy_scene(seed)), phase_(static_cast<std::uint32_t>(seed % 5)) {
    for (const std::uint64_t other : {seed, seed + 1})
      plans_.push_back(compile_plan(lend(scene_), busy_needs(other, scene_)));
    take_plan(0);
  }

  void step(std::uint32_t seed) {
    if (seed % 13 == 0) take_plan(seed / 13 % 2);
    if (seed % 7 == 0) level_ = static_cast<UpdateLevel>(seed / 7 % 3);
    inputs_->step(seed);
    FrameBuffer& frame = buffers_[number_ % 2];
    frame.count_from(number_);
    if (has_run_) frame.follow(buffers_[(number_ + 1) % 2]);
    has_run_ = true;
    RC_ASSERT(run_plan(*plan_, held_->next(inputs_->view(), level_, number_, phase_), frame) == ErrorCode::ok);
    reference_held_->next(*inputs_, level_, number_, phase_);
    FrameBuffer fresh(*plan_);
    RC_ASSERT(run_plan(*plan_, reference_held_->view(), fresh) == ErrorCode::ok);
    RC_ASSERT(first_difference(frame.result(), fresh.result()) == "");
    ++number_;
  }

 private:
  void take_plan(std::size_t index) {
    plan_ = &plans_[index];
    buffers_.clear();
    for (int b = 0; b < 2; ++b) buffers_.emplace_back(*plan_);
    inputs_.emplace(*plan_);
    held_.emplace(*plan_);
    reference_held_.emplace(*inputs_);
    has_run_ = false;
  }

  Scene scene_;
  std::vector<Plan> plans_;
  const Plan* plan_ = nullptr;
  std::vector<FrameBuffer> buffers_;
  std::optional<RandomInputs> inputs_;
  std::optional<HeldInput> held_;
  std::optional<ReferenceHeldInput> reference_held_;
  UpdateLevel level_ = UpdateLevel::every;
  std::uint32_t phase_ = 0;
  std::uint64_t number_ = 0;
  bool has_run_ = false;
};

RC_GTEST_PROP(remembering_frames, held_inputs_show_the_pose_of_the_last_update, (std::uint64_t seed)) {
  const Steps steps = *some_steps();
  HeldCharacter character(seed);
  for (const std::uint32_t step : steps) character.step(step);
}

}  // namespace
}  // namespace sinew::test
