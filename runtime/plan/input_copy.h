// SPDX-License-Identifier: MIT
#pragma once
#include <memory_resource>
#include <vector>

#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/program_copy.h"

namespace sinew {

/// A frame's input that owns its arrays, so that it may be run after the caller's arrays are destroyed.
/// owns  copies of all arrays, allocated from `memory` with the room that the plan declares (Needs::in.layer_room).
///       Assigning an input that fits into this room allocates nothing
class InputCopy {
 public:
  explicit InputCopy(const Plan& plan, std::pmr::memory_resource& memory = *std::pmr::new_delete_resource())
      : layers_(&memory),
        next_layers_(&memory),
        weights_(&memory),
        out_of_view_(&memory),
        geometry_(&memory),
        program_(plan, memory) {
    layers_.reserve(plan.needs().in.layer_room());
    if (plan.needs().in.between_updates) next_layers_.reserve(plan.needs().in.layer_room());
    weights_.reserve(plan.scene().weight_count());
    out_of_view_.reserve(plan.scene().instances.size());
    geometry_.reserve(plan.needs().in.cached_instances.size());
  }

  /// Checks that assigning the input will allocate nothing.
  /// err  too_many_layers, size_mismatch (more weights, instances or sources than the plan has, poses of another size),
  ///      not_in_needs (more of a program's lists than the needs declare)
  ErrorCode check_room(const FrameInput& input) const noexcept {
    if (input.layers.size() > layers_.capacity() || input.next_layers.size() > next_layers_.capacity())
      return ErrorCode::too_many_layers;
    const bool fits = input.weights.size() <= weights_.capacity() &&
                      input.out_of_view.size() <= out_of_view_.capacity() &&
                      input.geometry.size() <= geometry_.capacity();
    return fits ? program_.check_room(input) : ErrorCode::size_mismatch;
  }

  void assign(const FrameInput& input) {
    layers_.assign(input.layers.begin(), input.layers.end());
    next_layers_.assign(input.next_layers.begin(), input.next_layers.end());
    weights_.assign(input.weights.begin(), input.weights.end());
    out_of_view_.assign(input.out_of_view.begin(), input.out_of_view.end());
    geometry_.assign(input.geometry.begin(), input.geometry.end());
    program_.assign(input);
    numbers_ = input;
  }

  bool is_asleep() const noexcept { return numbers_.asleep; }

  /// The input assigned last; valid until the next one is assigned.
  FrameInput view() const noexcept {
    FrameInput input = numbers_;
    input.layers = layers_;
    input.next_layers = next_layers_;
    input.weights = weights_;
    input.out_of_view = out_of_view_;
    input.geometry = geometry_;
    program_.show(input);
    return input;
  }

 private:
  std::pmr::vector<ClipLayer> layers_, next_layers_;
  std::pmr::vector<float> weights_;
  std::pmr::vector<std::uint8_t> out_of_view_;
  std::pmr::vector<GeometryInput> geometry_;
  ProgramCopy program_;
  FrameInput numbers_;  // its spans still point to the caller's arrays; they are not used
};

}  // namespace sinew
