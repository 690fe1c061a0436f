// SPDX-License-Identifier: MIT
#include "runtime/c/frame_input.h"

#include "runtime/c/glue/enums.h"
#include "runtime/c/glue/list_field.h"
#include "runtime/c/page_handle.h"
#include "runtime/c/program_input.h"
#include "runtime/c/vertex_source.h"

namespace sinew::c {
namespace {

/// sinew_layer::kind holds the kind of a layer and the flag for mirroring.
struct LayerKindField {
  const char* name = "kind";
  const char* rule = "there is no such kind of layer";

  sinew_error read(const sinew_layer& given, ClipLayer& layer) const noexcept {
    layer.mirrored = (given.kind & SINEW_LAYER_MIRRORED) != 0;
    return from_c(given.kind & ~SINEW_LAYER_MIRRORED, layer.kind);
  }
  void write(const ClipLayer& layer, sinew_layer& out) const noexcept {
    out.kind = std::uint32_t{to_c(layer.kind)} | (layer.mirrored ? SINEW_LAYER_MIRRORED : 0u);
  }
};

constexpr auto kLayer = fields(
    field<&sinew_layer::time_s, &ClipLayer::time_s>(), field<&sinew_layer::clip, &ClipLayer::clip>(),
    field<&sinew_layer::mask, &ClipLayer::mask>(), field<&sinew_layer::weight, &ClipLayer::weight>(), LayerKindField{});
constexpr auto kGeometry = fields(field<&sinew_geometry_input::source, &GeometryInput::source>(),
                                  field<&sinew_geometry_input::time_s, &GeometryInput::time_s>(),
                                  field<&sinew_geometry_input::weight, &GeometryInput::weight>());

/// All fields of an input that are not lists of structs.
constexpr auto kInputNumbers = fields(
    field<&sinew_frame_input::weights, &FrameInput::weights>("weights"),
    field<&sinew_frame_input::root, &FrameInput::root>(), field<&sinew_frame_input::asleep, &FrameInput::asleep>(),
    field<&sinew_frame_input::interpolation_factor, &FrameInput::interpolation_factor>());

constexpr auto kLayers =
    list_field<&sinew_frame_input::layers, &sinew_frame_input::layer_count, &FrameInput::layers, &InputRoom::layers,
               &InputRoomOfC::layers>({"layers", SINEW_TOO_MANY_LAYERS}, kLayer);
constexpr auto kNextLayers =
    list_field<&sinew_frame_input::next_layers, &sinew_frame_input::next_layer_count, &FrameInput::next_layers,
               &InputRoom::next_layers, &InputRoomOfC::next_layers>({"next_layers", SINEW_TOO_MANY_LAYERS}, kLayer);
constexpr auto kSources = list_field<&sinew_frame_input::geometry, &sinew_frame_input::geometry_count,
                                     &FrameInput::geometry, &InputRoom::geometry, &InputRoomOfC::geometry>(
    {"geometry", SINEW_SIZE_MISMATCH, kNotEachSource}, kGeometry);

/// in   pages  [layers], or null if no layer has a page
void read_pages(const sinew_page* const* pages, std::span<ClipLayer> layers) noexcept {
  for (std::size_t i = 0; i < layers.size(); ++i) layers[i].page = pages != nullptr ? clip_of(pages[i]) : nullptr;
}

/// Returns `room`, or null if no layer has a page.
const sinew_page* const* write_pages(std::span<const ClipLayer> layers, std::span<const sinew_page*> room) noexcept {
  bool any = false;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    room[i] = page_of(layers[i].page);
    any = any || room[i] != nullptr;
  }
  return any ? room.data() : nullptr;
}

}  // namespace

NotRead read_layers(const sinew_layer* given, std::size_t count, const char* list, std::span<ClipLayer> room,
                    std::span<const ClipLayer>& layers) noexcept {
  const NotRead why = read_list({list, SINEW_TOO_MANY_LAYERS}, kLayer, given, count, room, layers);
  if (why.error == SINEW_OK) read_pages(nullptr, room.first(count));
  return why;
}

NotRead read_input(const sinew_frame_input* given, const sinew_plan& plan, const InputRoom& room,
                   FrameInput& input) noexcept {
  sinew_frame_input own = sinew_default_input();
  if (const sinew_error error = read_struct(given, own)) return refuse(error, {.field = "struct_size"});
  NotRead why = kInputNumbers.read(own, input);
  if (why.error != SINEW_OK) return why;
  if (input.weights.size() > plan.scene->scene.weight_count())
    return refuse(SINEW_SIZE_MISMATCH, {.rule = kNotEachWeight, .list = "weights"});
  why = kLayers.read(own, room, input);
  if (why.error != SINEW_OK) return why;
  read_pages(own.pages, room.layers.first(own.layer_count));
  input.next_layers = {};
  if (own.interpolation_factor != 0.0f) {
    if (!plan.plan.needs().in.between_updates)
      return refuse(SINEW_NOT_IN_NEEDS, {.field = "interpolation_factor", .rule = kNoUpdates});
    why = kNextLayers.read(own, room, input);
    if (why.error != SINEW_OK) return why;
    read_pages(own.next_pages, room.next_layers.first(own.next_layer_count));
  }
  why = read_program(own, plan.plan.needs().in.program, room, input);
  if (why.error != SINEW_OK) return why;
  input.out_of_view = {own.out_of_view, own.out_of_view != nullptr ? plan.scene->scene.instances.size() : 0};
  return kSources.read(own, room, input);
}

sinew_error write_input(const FrameInput& input, const InputRoomOfC& room, sinew_frame_input* out) noexcept {
  sinew_frame_input own = written<sinew_frame_input>(kInputNumbers, input);
  kLayers.write(input, room, own);
  kNextLayers.write(input, room, own);
  kSources.write(input, room, own);
  own.pages = write_pages(input.layers, room.pages);
  own.next_pages = write_pages(input.next_layers, room.next_pages);
  own.out_of_view = input.out_of_view.empty() ? nullptr : input.out_of_view.data();
  write_program(input, room, own);
  return write_struct(own, out);
}

}  // namespace sinew::c

sinew_frame_input sinew_default_input(void) {
  return sinew::c::written<sinew_frame_input>(sinew::c::kInputNumbers, sinew::FrameInput{});
}
