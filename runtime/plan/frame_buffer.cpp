// SPDX-License-Identifier: MIT
#include "runtime/plan/frame_buffer.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include "runtime/base/contract.h"
#include "runtime/base/prefetch.h"
#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/plan/find_hidden.h"
#include "runtime/plan/frame_tables.h"
#include "runtime/plan/plays_alone.h"
#include "runtime/plan/same_layers.h"

namespace sinew {
namespace {

/// Nothing where it is not looked at.
std::span<const ClipLayer> ahead_of(const FrameInput& input) noexcept {
  return input.interpolation_factor == 0.0f ? std::span<const ClipLayer>{} : input.next_layers;
}

/// As FrameTables::input_out_of_view.
std::uint8_t out_of_view(const FrameInput& input, std::size_t instance) noexcept {
  return !input.out_of_view.empty() && input.out_of_view[instance] != 0;
}

/// The clip that plays; kNone: none does.
std::uint32_t clip_of(std::span<const ClipLayer> layers) noexcept {
  const auto playing =
      std::find_if(layers.begin(), layers.end(), [](const ClipLayer& layer) { return layer.weight != 0.0f; });
  return playing != layers.end() ? playing->clip : kNone;
}

/// No clip that plays has tracks of joints.
bool leave_joints_at_rest(const Plan& plan, std::span<const ClipLayer> layers) noexcept {
  return std::none_of(layers.begin(), layers.end(), [&](const ClipLayer& layer) {
    return layer.weight != 0.0f && plan.clip_tracks[layer.clip].moves_joints;
  });
}

}  // namespace

void FrameBuffer::GiveBack::operator()(std::byte* block) const noexcept {
  if (memory != nullptr) memory->deallocate(block, byte_count, kAlignment);
}

FrameBuffer::FrameBuffer(const Plan& plan, std::pmr::memory_resource& memory)
    : FrameBuffer(plan, std::unique_ptr<std::byte, GiveBack>(
                            static_cast<std::byte*>(memory.allocate(plan.frame_bytes, kAlignment)),
                            GiveBack{&memory, plan.frame_bytes})) {}

FrameBuffer::FrameBuffer(const Plan& plan, std::span<std::byte> block)
    : FrameBuffer(plan, std::unique_ptr<std::byte, GiveBack>(block.data(), GiveBack{})) {
  CONTRACT(block.size() >= plan.frame_bytes);
}

FrameBuffer::FrameBuffer(const Plan& plan, std::unique_ptr<std::byte, GiveBack> block)
    : scene_(plan.scene), fingerprint_(plan.fingerprint), block_(std::move(block)) {
  CONTRACT(reinterpret_cast<std::uintptr_t>(block_.get()) % kAlignment == 0);
  const FrameMemory memory{block_.get()};
  std::memset(memory.block, 0, plan.frame_bytes);
  const FrameTables tables(plan, memory);
  std::uninitialized_value_construct(tables.instances.begin(), tables.instances.end());
  for (std::size_t p = 0; p < plan.primitives.size(); ++p)
    std::construct_at(&tables.primitives[p], nothing_deformed(plan.primitives[p]));
  std::uninitialized_value_construct(tables.palettes.begin(), tables.palettes.end());
  std::uninitialized_value_construct(tables.blend_layers.begin(), tables.blend_layers.end());
  std::uninitialized_value_construct(tables.input_layers.begin(), tables.input_layers.end());
  if (plan.interpolate) {
    std::uninitialized_value_construct(tables.input_ahead.begin(), tables.input_ahead.end());
    std::uninitialized_value_construct(tables.ends.begin(), tables.ends.end());
    for (const std::size_t at : plan.tables.end_layers_at) {
      const std::span<ClipLayer> layers = memory.array<ClipLayer>(at, plan.tables.input_layer_count);
      std::uninitialized_value_construct(layers.begin(), layers.end());
    }
  }
  const Skeleton& skeleton = *plan.rig.skeleton;
  const PoseSpan rest = memory.pose(plan.rest_pose_at, skeleton.joint_count());
  for (std::size_t j = 0; j < rest.stride; ++j) {
    Transform local = j < rest.joint_count ? skeleton.rest[j] : Transform{};
    local.rotation = without_tiny(
        local.rotation);  // as clips have it: a joint that rests has the same bits with any clip and without
    rest.set(j, local);
  }
  if (plan.hide) find_hidden(*plan.scene, {}, memory.array<bool>(plan.hidden_at, plan.rig.places.size()));
}

void FrameBuffer::prefetch(const Plan& plan) const noexcept {
  constexpr std::size_t kMostBytes = 24 * 1024;  // of the nearest cache the character that runs needs some
  sinew::prefetch(block_.get(), std::min(plan.front_bytes, kMostBytes));
}

bool FrameBuffer::holds_result_of(const Plan& plan, const FrameInput& input) const noexcept {
  return holds_result_of(FrameTables(plan, FrameMemory{block_.get()}), input);
}

bool FrameBuffer::holds_result_of(const FrameTables& tables, const FrameInput& input) const noexcept {
  if (!keeps_input_ || input.asleep != asleep_) return false;
  if (input.asleep) return true;  // whatever it would do
  if (input.layers.size() != layer_count_ || input.weights.size() != weight_count_) return false;
  if (!same_bits(input.interpolation_factor, interpolation_factor_) || ahead_of(input).size() != ahead_count_)
    return false;
  for (std::size_t i = 0; i < tables.input_out_of_view.size(); ++i)
    if (out_of_view(input, i) != tables.input_out_of_view[i]) return false;
  return same_layers(input.layers, tables.input_layers.first(layer_count_)) &&
         same_layers(ahead_of(input), tables.input_ahead.first(ahead_count_)) &&
         same_bits<float>(input.weights, tables.input_weights.first(weight_count_)) && same_bits(input.root, root_);
}

StandingJoints FrameBuffer::standing(const Plan& plan, const FrameTables& tables,
                                     const FrameInput& input) const noexcept {
  if (!keeps_input_ || asleep_ || !same_bits(input.root, root_)) return StandingJoints::none;
  const std::span<const ClipLayer> last = tables.input_layers.first(layer_count_);
  const bool between = input.interpolation_factor != 0.0f || interpolation_factor_ != 0.0f;
  const bool at_rest = !between && plays_alone(input.layers) && plays_alone(last) &&
                       leave_joints_at_rest(plan, input.layers) && leave_joints_at_rest(plan, last);
  return at_rest || plan.moved_joints.empty() ? StandingJoints::all : StandingJoints::unmoved;
}

bool FrameBuffer::holds_clip(const FrameTables& tables, const FrameInput& input) const noexcept {
  if (!keeps_input_ || asleep_) return false;
  const std::span<const ClipLayer> last = tables.input_layers.first(layer_count_);
  return plays_alone(input.layers) && plays_alone(last) && clip_of(input.layers) != kNone &&
         clip_of(input.layers) == clip_of(last);
}

/// More layers than there is room for are not kept: then the next frame is taken for a new one.
void FrameBuffer::keep(const FrameTables& tables, const FrameInput& input) noexcept {
  asleep_ = input.asleep;
  const std::span<const ClipLayer> ahead = ahead_of(input);
  keeps_input_ = input.layers.size() <= tables.input_layers.size() && ahead.size() <= tables.input_ahead.size();
  if (!keeps_input_) return;
  ahead_count_ = ahead.size(), interpolation_factor_ = input.interpolation_factor;
  std::copy(ahead.begin(), ahead.end(), tables.input_ahead.begin());
  layer_count_ = input.layers.size(), weight_count_ = input.weights.size(), root_ = input.root;
  std::copy(input.layers.begin(), input.layers.end(), tables.input_layers.begin());
  std::copy(input.weights.begin(), input.weights.end(), tables.input_weights.begin());
  for (std::size_t i = 0; i < tables.input_out_of_view.size(); ++i) tables.input_out_of_view[i] = out_of_view(input, i);
}

}  // namespace sinew
