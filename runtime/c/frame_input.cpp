// SPDX-License-Identifier: MIT
#include "runtime/c/frame_input.h"

#include <cmath>

#include "runtime/c/boundary.h"
#include "runtime/c/page_handle.h"

namespace sinew::c {
namespace {

static_assert(sizeof(VertexSource) <= sizeof(sinew_vertex_source));
static_assert(static_cast<int>(LayerKind::add_to_rest) == SINEW_LAYER_ADD_TO_REST &&
              static_cast<int>(LayerKind::add_to_start) == SINEW_LAYER_ADD_TO_START);

/// Writes layers and their pages behind one another into `room`, of which it takes what it needs.
const sinew_layer* write_layers(std::span<const ClipLayer> layers, InputRoomOfC& room,
                                const sinew_page* const*& pages) noexcept {
  sinew_layer* first = room.layers.data();
  const sinew_page** first_page = room.pages.data();
  bool any = false;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    first_page[i] = page_of(layers[i].page);
    any = any || layers[i].page != nullptr;
  }
  pages = any ? first_page : nullptr;
  room.pages = room.pages.subspan(layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i)
    first[i] = {layers[i].time_s, layers[i].clip, layers[i].mask, layers[i].weight,
                static_cast<std::uint32_t>(layers[i].kind) | (layers[i].mirrored ? SINEW_LAYER_MIRRORED : 0u)};
  room.layers = room.layers.subspan(layers.size());
  return layers.empty() ? nullptr : first;
}

}  // namespace

NotRead read_layers(const sinew_layer* given, const sinew_page* const* pages, std::size_t count, const char* list,
                    std::span<ClipLayer> room, std::span<const ClipLayer>& layers) noexcept {
  if (count > 0 && given == nullptr) return refuse(SINEW_NULL_ARGUMENT, {.list = list});
  if (count > room.size()) return refuse(SINEW_TOO_MANY_LAYERS, {.list = list});
  for (std::size_t i = 0; i < count; ++i) {
    const sinew_layer& layer = given[i];
    const std::uint32_t kind = layer.kind & ~SINEW_LAYER_MIRRORED;
    if (kind > SINEW_LAYER_ADD_TO_START)
      return refuse(SINEW_UNSUPPORTED, {.field = "kind",
                                        .rule = "there is no such kind of layer",
                                        .list = list,
                                        .index = static_cast<std::uint32_t>(i)});
    const bool mirrored = layer.kind != kind;
    room[i] = {layer.clip,
               layer.time_s,
               layer.weight,
               layer.mask,
               static_cast<LayerKind>(kind),
               mirrored,
               pages != nullptr ? clip_of(pages[i]) : nullptr};
  }
  layers = room.first(count);
  return {};
}

NotRead read_input(const sinew_frame_input* given, const sinew_plan& plan, const InputRoom& room,
                   FrameInput& input) noexcept {
  sinew_frame_input own = sinew_default_input();
  if (const sinew_error error = read_struct(given, own); error != SINEW_OK)
    return refuse(error, {.field = "struct_size"});
  if (own.weights.count > 0 && own.weights.data == nullptr) return refuse(SINEW_NULL_ARGUMENT, {.list = "weights"});
  if (own.weights.count > plan.scene->scene.weight_count())
    return refuse(SINEW_SIZE_MISMATCH, {.rule = kNotEachWeight, .list = "weights"});
  const std::size_t layer_room = plan.plan.needs().in.layer_room();
  NotRead why =
      read_layers(own.layers, own.pages, own.layer_count, "layers", room.layers.first(layer_room), input.layers);
  if (why.error != SINEW_OK) return why;
  input.next_layers = {};
  if (own.interpolation_factor != 0.0f) {
    if (!plan.plan.needs().in.between_updates)
      return refuse(SINEW_NOT_IN_NEEDS, {.field = "interpolation_factor", .rule = kNoUpdates});
    why = read_layers(own.next_layers, own.next_pages, own.next_layer_count, "next_layers",
                      room.layers.subspan(layer_room), input.next_layers);
    if (why.error != SINEW_OK) return why;
  }
  why = read_program(own, plan.plan.needs().in.program, room.program, input);
  if (why.error != SINEW_OK) return why;
  if (own.geometry_count > 0 && own.geometry == nullptr) return refuse(SINEW_NULL_ARGUMENT, {.list = "geometry"});
  if (own.geometry_count > room.geometry.size())
    return refuse(SINEW_SIZE_MISMATCH, {.rule = kNotEachSource, .list = "geometry"});
  input.geometry = room.geometry.first(own.geometry_count);
  for (std::size_t i = 0; i < own.geometry_count; ++i) {
    copy_bits(own.geometry[i].source, room.geometry[i].source);
    room.geometry[i].time_s = own.geometry[i].time_s;
    room.geometry[i].weight = own.geometry[i].weight;
  }
  input.interpolation_factor = own.interpolation_factor;
  input.weights = {own.weights.data, own.weights.count};
  input.out_of_view = {};
  if (own.out_of_view != nullptr) input.out_of_view = {own.out_of_view, plan.scene->scene.instances.size()};
  input.asleep = own.asleep != 0;
  copy_bits(own.root, input.root);
  return {};
}

sinew_error write_input(const FrameInput& input, InputRoomOfC room, sinew_frame_input* out) noexcept {
  sinew_frame_input own = sinew_default_input();
  own.layers = write_layers(input.layers, room, own.pages);
  own.layer_count = input.layers.size();
  own.next_layers = write_layers(input.next_layers, room, own.next_pages);
  own.next_layer_count = input.next_layers.size();
  own.interpolation_factor = input.interpolation_factor;
  own.weights = {input.weights.data(), input.weights.size()};
  copy_bits(input.root, own.root);
  own.out_of_view = input.out_of_view.empty() ? nullptr : input.out_of_view.data();
  own.asleep = input.asleep;
  own.geometry_count = input.geometry.size();
  if (own.geometry_count > 0) own.geometry = room.geometry.data();
  for (std::size_t i = 0; i < own.geometry_count; ++i) {
    room.geometry[i] = {{}, input.geometry[i].time_s, input.geometry[i].weight};
    copy_bits(input.geometry[i].source, room.geometry[i].source);
  }
  write_program(input, room.program, own);
  return write_struct(own, out);
}

}  // namespace sinew::c

sinew_frame_input sinew_default_input(void) {
  return {.struct_size = sizeof(sinew_frame_input),
          .layers = nullptr,
          .layer_count = 0,
          .weights = {nullptr, 0},
          .root = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
          .out_of_view = nullptr,
          .asleep = 0,
          .next_layers = nullptr,
          .next_layer_count = 0,
          .interpolation_factor = 0.0f,
          .geometry = nullptr,
          .geometry_count = 0,
          .pages = nullptr,
          .next_pages = nullptr,
          .program = nullptr,
          .op_count = 0,
          .program_inputs = nullptr};
}
