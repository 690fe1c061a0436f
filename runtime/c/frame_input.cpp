// SPDX-License-Identifier: MIT
#include "runtime/c/frame_input.h"

#include "runtime/c/boundary.h"

namespace sinew::c {

static_assert(static_cast<int>(LayerKind::add_to_rest) == SINEW_LAYER_ADD_TO_REST &&
              static_cast<int>(LayerKind::add_to_start) == SINEW_LAYER_ADD_TO_START);

sinew_error read_input(const sinew_frame_input* given, const sinew_plan& plan, std::span<ClipLayer> room,
                       FrameInput& input) noexcept {
  sinew_frame_input own = sinew_default_input();
  if (const sinew_error error = read_struct(given, own); error != SINEW_OK) return error;
  if ((own.layer_count > 0 && own.layers == nullptr) || (own.weights.count > 0 && own.weights.data == nullptr))
    return SINEW_NULL_ARGUMENT;
  if (own.layer_count > plan.layer_room()) return SINEW_SIZE_MISMATCH;
  for (std::size_t i = 0; i < own.layer_count; ++i) {
    const sinew_layer& layer = own.layers[i];
    if (layer.kind > SINEW_LAYER_ADD_TO_START) return SINEW_UNSUPPORTED;
    room[i] = {layer.clip, layer.time_s, layer.weight, layer.mask, static_cast<LayerKind>(layer.kind)};
  }
  input.layers = room.first(own.layer_count);
  input.weights = {own.weights.data, own.weights.count};
  if (own.out_of_view != nullptr)
    input.out_of_view = {own.out_of_view, plan.plan.scene->instances.size()};
  else
    input.out_of_view = {};
  input.asleep = own.asleep != 0;
  copy_bits(own.root, input.root);
  return SINEW_OK;
}

}  // namespace sinew::c

sinew_frame_input sinew_default_input(void) {
  return {.struct_size = sizeof(sinew_frame_input),
          .layers = nullptr,
          .layer_count = 0,
          .weights = {nullptr, 0},
          .root = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
          .out_of_view = nullptr,
          .asleep = 0};
}
