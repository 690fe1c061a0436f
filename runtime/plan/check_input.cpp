// SPDX-License-Identifier: MIT
#include "runtime/plan/check_input.h"

#include <cmath>

#include "runtime/base/all_finite.h"
#include "runtime/base/same_bits.h"

namespace sinew {
namespace {

/// Without a branch per number: zero times an infinity or NaN is NaN, and stays so in sums.
bool is_finite(const Affine& m) noexcept {
  const glm::vec4 zero = 0.0f * m.row[0] + 0.0f * m.row[1] + 0.0f * m.row[2];
  return zero.x + zero.y + zero.z + zero.w == 0.0f;
}

/// A page of another clip with as many targets is the caller's mistake, which no frame looks for.
bool has_size_of(const Clip& page, const Clip& clip) noexcept {
  return page.joint_count() == clip.joint_count() && page.weight_count() == clip.weight_count() &&
         page.property_count() == clip.property_count();
}

ErrorCode check(const CompiledPlan& plan, std::span<const ClipLayer> layers) noexcept {
  std::size_t active = 0;
  double total_weight = 0.0;
  for (const ClipLayer& layer : layers) {
    if (layer.clip >= plan.assets.clips.size()) return ErrorCode::index_out_of_range;
    if (layer.page != nullptr && !has_size_of(*layer.page, plan.assets.clips[layer.clip]))
      return ErrorCode::size_mismatch;
    if (!std::isfinite(layer.time_s) || !std::isfinite(layer.weight)) return ErrorCode::not_finite;
    if (layer.mask != kNone && layer.mask >= plan.needs.masks.size()) return ErrorCode::index_out_of_range;
    const bool adds = layer.kind != LayerKind::blend;
    if (layer.weight < 0.0f || (adds && !plan.needs.additive)) return ErrorCode::unsupported;
    if (layer.mirrored && plan.needs.mirror == nullptr) return ErrorCode::unsupported;
    if (adds) continue;
    active += layer.weight != 0.0f;
    total_weight += static_cast<double>(layer.weight);
  }
  if (active > plan.needs.max_layers) return ErrorCode::size_mismatch;
  return plan.sample && !plan.blend && active > 0 && total_weight < 1.0 ? ErrorCode::unsupported : ErrorCode::ok;
}

/// A source is at one time in a frame: an earlier instance that plays from it has another one.
bool has_two_times(std::span<const GeometryInput> geometry, std::size_t slot) noexcept {
  for (std::size_t s = slot; s-- > 0;)
    if (geometry[s].plays() && geometry[s].source.context == geometry[slot].source.context)
      return !same_bits(geometry[s].time_s, geometry[slot].time_s);
  return false;
}

ErrorCode check_geometry(const CompiledPlan& plan, std::span<const GeometryInput> geometry) noexcept {
  if (geometry.empty()) return ErrorCode::ok;
  if (geometry.size() != plan.needs.cached_instances.size()) return ErrorCode::size_mismatch;
  for (std::size_t slot = 0; slot < geometry.size(); ++slot) {
    const GeometryInput& input = geometry[slot];
    if (!input.source.is_there()) continue;
    if (!std::isfinite(input.time_s) || !std::isfinite(input.weight)) return ErrorCode::not_finite;
    if (input.weight < 0.0f || input.weight > 1.0f) return ErrorCode::unsupported;
    if (!input.plays()) continue;
    const std::uint32_t instance = plan.needs.cached_instances[slot];
    if (!input.source.has(input.source.context, instance)) return ErrorCode::index_out_of_range;
    const bool has_copies = !plan.scene->instances[instance].copies.empty();
    if ((has_copies && input.source.space == VertexSpace::scene) || has_two_times(geometry, slot))
      return ErrorCode::unsupported;
  }
  return ErrorCode::ok;
}

}  // namespace

ErrorCode check(const CompiledPlan& plan, const FrameInput& input) noexcept {
  if (!(input.interpolation_factor >= 0.0f && input.interpolation_factor <= 1.0f) ||
      (input.interpolation_factor != 0.0f && !plan.needs.between_updates))
    return ErrorCode::unsupported;
  for (const std::span<const ClipLayer> layers :
       {input.layers, input.interpolation_factor != 0.0f ? input.next_layers : std::span<const ClipLayer>{}})
    if (const ErrorCode error = check(plan, layers); error != ErrorCode::ok) return error;
  if (!input.weights.empty() && input.weights.size() != plan.rest_weights.size()) return ErrorCode::size_mismatch;
  if (!input.out_of_view.empty() && input.out_of_view.size() != plan.scene->instances.size())
    return ErrorCode::size_mismatch;
  if (!all_finite(input.weights) || !is_finite(input.root)) return ErrorCode::not_finite;
  return check_geometry(plan, input.geometry);
}

}  // namespace sinew
