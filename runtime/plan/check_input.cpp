// SPDX-License-Identifier: MIT
#include "runtime/plan/check_input.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/same_bits.h"
#include "runtime/plan/playing_layers.h"
#include "runtime/plan/pose_operations.h"
#include "runtime/plan/reuse/program_versions.h"

namespace sinew {
namespace {

#define RETURN_IF_REFUSED(check) \
  if (const Refusal refusal = (check); refusal.error != ErrorCode::ok) return refusal

constexpr Refusal kFine{};

/// False for NaN too.
bool is_usual(float number) noexcept { return std::abs(number) <= kLargestInput; }
bool is_fraction(float number) noexcept { return number >= 0.0f && number <= 1.0f; }

ErrorCode unusual(float number) noexcept {
  return std::isfinite(number) ? ErrorCode::too_large : ErrorCode::not_finite;
}

/// Pages are compared by their sizes only. A page of another clip with the same sizes is a mistake that no frame
/// detects.
bool has_size_of(const Clip& page, const Clip& clip) noexcept {
  return page.joint_count() == clip.joint_count() && page.weight_count() == clip.weight_count() &&
         page.property_count() == clip.property_count();
}

/// in   masks  number of masks that the layer may name
Refusal check_layer(const CompiledPlan& plan, const ClipLayer& layer, std::size_t masks) noexcept {
  const bool adds = layer.kind != LayerKind::blend;
  if (layer.clip >= plan.assets.clips.size())
    return {ErrorCode::index_out_of_range, "clip", "the plan was compiled for fewer clips"};
  if (layer.page != nullptr && !has_size_of(*layer.page, plan.assets.clips[layer.clip]))
    return {ErrorCode::wrong_page, "page"};
  if (layer.mask != kNone && layer.mask >= std::min<std::size_t>(masks, PoseOp::kNoMask))
    return {ErrorCode::index_out_of_range, "mask", "needs and input together have fewer masks"};
  if (!std::isfinite(layer.time_s)) return {ErrorCode::not_finite, "time_s"};
  if (!is_usual(layer.weight)) return {unusual(layer.weight), "weight"};
  if (layer.weight < 0.0f && !adds)
    return {ErrorCode::negative_weight, "weight", "a weight is below 0, and only additive layers subtract"};
  if (adds && !plan.needs.in.additive)
    return {ErrorCode::not_in_needs, "kind", "additive layers are not declared in the needs"};
  if (layer.mirrored && plan.needs.in.mirror == nullptr)
    return {ErrorCode::not_in_needs, "mirrored", "the needs have no mirror"};
  return kFine;
}

Refusal check_layers(const CompiledPlan& plan, std::span<const ClipLayer> layers, std::size_t masks,
                     const char* list) noexcept {
  std::size_t blended = 0;
  double total_weight = 0.0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (Refusal refusal = check_layer(plan, layers[i], masks); refusal.error != ErrorCode::ok) {
      refusal.list = list;
      refusal.index = static_cast<std::uint32_t>(i);
      return refusal;
    }
    if (layers[i].kind != LayerKind::blend) continue;
    blended += layers[i].weight != 0.0f;
    total_weight += static_cast<double>(layers[i].weight);
  }
  constexpr std::size_t kMostOfMean = 0xFFFF;  // operands that PoseOp::index can count
  if (blended > std::min<std::size_t>(plan.needs.in.max_layers, kMostOfMean))
    return {ErrorCode::too_many_layers, nullptr, "more layers blend than the needs declare", list};
  if (plan.sample && !plan.blend && blended > 0 && total_weight < 1.0)
    return {ErrorCode::not_in_needs, nullptr, "a plan of one layer does not blend: the weight must be 1", list};
  return kFine;
}

/// True if an earlier cached instance plays the same source at another time.
bool has_two_times(std::span<const GeometryInput> geometry, std::size_t slot) noexcept {
  for (std::size_t s = slot; s-- > 0;)
    if (geometry[s].plays() && geometry[s].source.context == geometry[slot].source.context)
      return !same_bits(geometry[s].time_s, geometry[slot].time_s);
  return false;
}

Refusal check_source(const CompiledPlan& plan, std::span<const GeometryInput> geometry, std::size_t slot) noexcept {
  const GeometryInput& input = geometry[slot];
  const std::uint32_t instance = plan.needs.in.cached_instances[slot];
  if (!std::isfinite(input.time_s)) return {ErrorCode::not_finite, "time_s"};
  if (!std::isfinite(input.weight)) return {ErrorCode::not_finite, "weight"};
  if (!is_fraction(input.weight)) return {ErrorCode::not_a_fraction, "weight"};
  if (!input.plays()) return kFine;
  if (!input.source.has(input.source.context, instance))
    return {ErrorCode::index_out_of_range, "source", "it has no vertices of the mesh instance"};
  if (!plan.scene->instances[instance].copies.empty() && input.source.space == VertexSpace::scene)
    return {ErrorCode::unsupported, "source", "it is in scene space, and the mesh instance has copies"};
  if (has_two_times(geometry, slot)) return {ErrorCode::two_times, "time_s"};
  return kFine;
}

Refusal check_geometry(const CompiledPlan& plan, std::span<const GeometryInput> geometry) noexcept {
  for (std::size_t slot = 0; slot < geometry.size(); ++slot) {
    if (!geometry[slot].source.is_there()) continue;
    if (Refusal refusal = check_source(plan, geometry, slot); refusal.error != ErrorCode::ok) {
      refusal.list = "geometry";
      refusal.index = static_cast<std::uint32_t>(slot);
      return refusal;
    }
  }
  return kFine;
}

Refusal check_numbers(std::span<const float> numbers, const char* list) noexcept {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!is_usual(numbers[i])) return {unusual(numbers[i]), nullptr, nullptr, list, static_cast<std::uint32_t>(i)};
  return kFine;
}

/// Checks that each array is empty or has one entry for each of the plan's own.
Refusal check_counts(const CompiledPlan& plan, const FrameInput& input) noexcept {
  const auto fits = [](std::size_t count, std::size_t planned) { return count == 0 || count == planned; };
  if (!fits(input.weights.size(), plan.rest_weights.size()))
    return {ErrorCode::size_mismatch, nullptr, kNotEachWeight, "weights"};
  if (!fits(input.out_of_view.size(), plan.scene->instances.size()))
    return {ErrorCode::size_mismatch, nullptr, "not one for each mesh instance of the scene", "out_of_view"};
  if (!fits(input.geometry.size(), plan.needs.in.cached_instances.size()))
    return {ErrorCode::size_mismatch, nullptr, kNotEachSource, "geometry"};
  return kFine;
}

Refusal check_factor(const CompiledPlan& plan, float factor) noexcept {
  if (!is_fraction(factor)) return {ErrorCode::not_a_fraction, "interpolation_factor"};
  if (factor != 0.0f && !plan.needs.in.between_updates)
    return {ErrorCode::not_in_needs, "interpolation_factor", kNoUpdates};
  return kFine;
}

Refusal check_root(const Affine& root) noexcept {
  int unusual = 0;  // counted without a branch for each number
  for (const glm::vec4& row : root.row)
    unusual += !is_usual(row.x) + !is_usual(row.y) + !is_usual(row.z) + !is_usual(row.w);
  if (unusual == 0) return kFine;
  for (const glm::vec4& row : root.row)
    for (int c = 0; c < 4; ++c)
      if (!std::isfinite(row[c])) return {ErrorCode::not_finite, "root"};
  return {ErrorCode::too_large, "root"};
}

/// Checks that the lists of a program's inputs are not longer than the needs declare.
Refusal check_program_lists(const CompiledPlan& plan, const PoseProgramInputs& inputs) noexcept {
  const PoseProgramRoom& room = plan.needs.in.program;
  if (inputs.externals.size() > room.externals)
    return {ErrorCode::not_in_needs, nullptr, kLongerThanNeeds, "externals"};
  if (inputs.overrides.size() > room.overrides)
    return {ErrorCode::not_in_needs, nullptr, kLongerThanNeeds, "overrides"};
  if (inputs.procedures.size() > room.procedures)
    return {ErrorCode::not_in_needs, nullptr, kLongerThanNeeds, "procedures"};
  if (inputs.masks.size() > room.masks) return {ErrorCode::not_in_needs, nullptr, kLongerThanNeeds, "masks"};
  std::size_t joints = 0;
  for (const JointOverrides& overrides : inputs.overrides) joints += overrides.joints.size();
  if (joints > room.overridden_joints)
    return {ErrorCode::not_in_needs, nullptr, "more joints than the needs declare", "overrides"};
  return kFine;
}

Refusal check_program_pages(const CompiledPlan& plan, const FrameInput& input) noexcept {
  const std::span<const Clip* const> pages = input.program_inputs.pages;
  if (pages.empty()) return kFine;
  if (pages.size() != input.program.size())
    return {ErrorCode::size_mismatch, nullptr, "not one for each operation", "pages"};
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const PoseOpKind kind = input.program[i].kind;
    const bool samples = kind == PoseOpKind::sample || kind == PoseOpKind::sample_mirrored;
    if (pages[i] != nullptr && samples && !has_size_of(*pages[i], plan.assets.clips[input.program[i].index]))
      return {ErrorCode::wrong_page, nullptr, nullptr, "pages", static_cast<std::uint32_t>(i)};
  }
  return kFine;
}

/// Checks the content of the lists.
Refusal check_program_inputs(const CompiledPlan& plan, const PoseProgramInputs& inputs) noexcept {
  const PoseInputFault wrong =
      find_fault(inputs, plan.assets.joint_count(), plan.rest_weights.size(), plan.scene->properties.rest.size());
  if (wrong.code != ErrorCode::ok) return {wrong.code, nullptr, wrong.rule, wrong.list, wrong.index};
  return kFine;
}

Refusal check_masks_of_layers(const CompiledPlan& plan, const PoseProgramInputs& masks) noexcept {
  RETURN_IF_REFUSED(check_program_lists(plan, masks));
  return check_program_inputs(plan, masks);
}

Refusal check_program(const CompiledPlan& plan, const FrameInput& input) noexcept {
  if (input.program.empty())
    return input.program_inputs.masks.empty() ? kFine : check_masks_of_layers(plan, inputs_in_use(input));
  const PoseProgramRoom& room = plan.needs.in.program;
  if (room.ops == 0) return {ErrorCode::not_in_needs, "program", "the needs declare no programs"};
  if (!input.layers.empty()) return {ErrorCode::unsupported, "program", "layers are given as well"};
  if (input.interpolation_factor != 0.0f)
    return {ErrorCode::unsupported, "interpolation_factor", "a program lays one cached pose over another"};
  if (input.program.size() > room.ops)
    return {ErrorCode::not_in_needs, "program", "it has more operations than the needs declare"};
  RETURN_IF_REFUSED(check_program_lists(plan, input.program_inputs));
  const PoseProgramFault fault = find_fault(input.program, program_limits(plan, input.program_inputs));
  if (fault.code != ErrorCode::ok)
    return {fault.code, nullptr, fault.rule, "program", static_cast<std::uint32_t>(fault.op)};
  for (std::size_t i = 0; i < input.program.size(); ++i)
    if (!is_usual(input.program[i].weight))
      return {ErrorCode::too_large, "weight", nullptr, "program", static_cast<std::uint32_t>(i)};
  RETURN_IF_REFUSED(check_program_pages(plan, input));
  return check_program_inputs(plan, input.program_inputs);
}

}  // namespace

Refusal check_input(const CompiledPlan& plan, const FrameInput& input) noexcept {
  RETURN_IF_REFUSED(check_factor(plan, input.interpolation_factor));
  const std::size_t masks = plan.masks.size() + input.program_inputs.masks.size();
  RETURN_IF_REFUSED(check_layers(plan, input.layers, masks, "layers"));
  RETURN_IF_REFUSED(check_layers(plan, next_layers_of(input), masks, "next_layers"));
  RETURN_IF_REFUSED(check_program(plan, input));
  RETURN_IF_REFUSED(check_counts(plan, input));
  RETURN_IF_REFUSED(check_numbers(input.weights, "weights"));
  RETURN_IF_REFUSED(check_root(input.root));
  RETURN_IF_REFUSED(check_geometry(plan, input.geometry));
  return kFine;
}

}  // namespace sinew
