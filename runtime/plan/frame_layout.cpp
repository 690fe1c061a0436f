// SPDX-License-Identifier: MIT
#include "runtime/plan/frame_layout.h"

#include <algorithm>

#include "runtime/deform/surface_normals.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/frame_tables.h"
#include "runtime/pose/correct_pose.h"

namespace sinew {
namespace {

/// Hands out parts of one block, each on cache lines of its own.
class BlockLayout {
 public:
  std::size_t take(std::size_t bytes) noexcept {
    const std::size_t at = end_;
    end_ += (bytes + kAlignment - 1) / kAlignment * kAlignment;
    return at;
  }
  template <class T>
  std::size_t take_array(std::size_t count) noexcept {
    return take(count * sizeof(T));
  }
  std::size_t size() const noexcept { return end_; }

 private:
  static constexpr std::size_t kAlignment = 64;
  std::size_t end_ = 0;
};

void lay_out_primitives(CompiledPlan& plan, BlockLayout& block) {
  std::size_t morphed_positions = 0, morphed_normals = 0, morphed_tangents = 0, scratch = 0;
  for (const PrimitivePlan& p : plan.primitives) {
    PrimitiveLayout& at = plan.layout.primitives.emplace_back();
    const std::size_t count = primitive_of(plan, p).vertex_count();
    const auto needed_between = [&](bool morph, bool skin) { return morph && skin ? count : 0; };
    if (p.morph.positions || p.skin.positions || p.cached.positions)
      at.positions_at = block.take_array<glm::vec3>(count);
    if (p.morph.normals || p.skin.normals || p.cached.normals || p.flat_normals)
      at.normals_at = block.take_array<glm::vec3>(count);
    if (p.morph.tangents || p.skin.tangents || p.cached.tangents) at.tangents_at = block.take_array<glm::vec4>(count);
    if (p.morph_colors) at.colors_at = block.take_array<glm::vec4>(count);
    morphed_positions = std::max(morphed_positions, needed_between(p.morph.positions, p.skin.any()));
    morphed_normals = std::max(morphed_normals, needed_between(p.morph.normals, p.skin.any()));
    morphed_tangents = std::max(morphed_tangents, needed_between(p.morph.tangents, p.skin.any()));
    if (p.morph.any()) scratch = std::max(scratch, count);
  }
  // Primitives run one after another: what lies between morph and skin is shared by all of them.
  plan.layout.morphed.positions_at = block.take_array<glm::vec3>(morphed_positions);
  plan.layout.morphed.normals_at = block.take_array<glm::vec3>(morphed_normals);
  plan.layout.morphed.tangents_at = block.take_array<glm::vec4>(morphed_tangents);
  plan.layout.scratch_at = block.take_array<glm::vec3>(scratch);
}

/// Primitives play one after another: what lies before the blend is shared by all of them.
void lay_out_geometry(CompiledPlan& plan, BlockLayout& block) {
  std::size_t positions = 0, normals = 0, tangents = 0, sums = 0;
  for (std::size_t p = 0; p < plan.primitives.size(); ++p) {
    const AttributeSet& cached = plan.primitives[p].cached;
    const std::size_t count = primitive_of(plan, plan.primitives[p]).vertex_count();
    if (cached.positions) positions = std::max(positions, count);
    if (cached.normals) normals = std::max(normals, count);
    if (cached.tangents) tangents = std::max(tangents, count);
    if (plan.surface_faces[p] != nullptr) sums = std::max(sums, surface_sums(*plan.surface_faces[p]));
  }
  plan.layout.cached.positions_at = block.take_array<glm::vec3>(positions);
  plan.layout.cached.normals_at = block.take_array<glm::vec3>(normals);
  plan.layout.cached.tangents_at = block.take_array<glm::vec4>(tangents);
  plan.layout.surface_sums_at = block.take_array<glm::vec4>(sums);
}

void lay_out_tables(CompiledPlan& plan, BlockLayout& block) {
  const Scene& scene = *plan.scene;
  TableLayout& tables = plan.layout.tables;
  tables.instance_count = scene.instances.size();
  tables.primitive_count = plan.primitives.size();
  tables.skin_count = scene.skins.size();
  tables.weight_count = scene.weight_count();
  tables.blend_layer_count = plan.needs.max_layers;
  tables.instances_at = block.take_array<InstanceResult>(scene.instances.size());
  tables.primitives_at = block.take_array<DeformedPrimitive>(plan.primitives.size());
  tables.blend_layers_at = block.take_array<BlendLayer>(plan.needs.max_layers);
  tables.palettes_at = block.take_array<SkinPalette>(plan.palette.size());
  tables.weights_since_at = block.take_array<std::uint64_t>(scene.instances.size());
  tables.winding_since_at = block.take_array<std::uint64_t>(scene.instances.size());
  tables.last_weights_at = block.take_array<float>(scene.weight_count());
  tables.input_weights_at = block.take_array<float>(scene.weight_count());
  tables.input_out_of_view_at = block.take_array<std::uint8_t>(scene.instances.size());
  tables.input_layer_count = plan.needs.layer_room();
  tables.stage_ns_at = block.take_array<std::uint64_t>(plan.needs.stage_times ? kStageCount : 0);
  tables.slot_count = plan.geometry_slot.empty() ? 0 : plan.needs.cached_instances.size();
  tables.shown_at = block.take_array<ShownVertices>(tables.slot_count);
  tables.played_at = block.take_array<PlayedGeometry>(tables.slot_count);
  tables.geometry_since_at = block.take_array<std::uint64_t>(tables.slot_count);
  tables.input_geometry_at = block.take_array<GeometryInput>(tables.slot_count);
  tables.input_layers_at = block.take_array<ClipLayer>(tables.input_layer_count);
  if (!plan.interpolate) return;
  tables.input_next_layers_at = block.take_array<ClipLayer>(tables.input_layer_count);
  tables.updates_at = block.take_array<KeptUpdate>(2);
  for (std::size_t& at : tables.update_layers_at) at = block.take_array<ClipLayer>(tables.input_layer_count);
}

/// The front of the block: what frames of one clip touch before vertices.
void lay_out_front(CompiledPlan& plan, std::size_t pose_bytes, std::size_t number_count, BlockLayout& block) {
  const Scene& scene = *plan.scene;
  lay_out_tables(plan, block);
  plan.layout.pose_at = block.take(plan.sample ? pose_bytes : 0);
  plan.layout.weights_at = block.take_array<float>(scene.weight_count());
  plan.layout.properties_at = block.take_array<float>(number_count);
  plan.layout.hidden_at = block.take_array<bool>(plan.hide ? scene.skeleton.joint_count() : 0);
  plan.layout.palette_wanted_at = block.take_array<bool>(scene.skins.size());
  plan.layout.model_at = block.take_array<Affine>(plan.local_to_model ? plan.assets.joint_count() : 0);
  for (std::size_t s = 0; s < scene.skins.size(); ++s) {
    const std::size_t joints = scene.skins[s].joints.size();
    plan.layout.palette_at.push_back(block.take_array<JointMatrix>(plan.palette[s] ? matrix_count(plan, s) : 0));
    plan.layout.split_at.push_back(block.take_array<RigidStretch>(plan.split[s] ? joints : 0));
  }
  plan.layout.stretch_at = block.take_array<bool>(scene.skins.size());
  plan.layout.front_bytes = block.size();
}

}  // namespace

void lay_out_frame(CompiledPlan& plan) {
  const Scene& scene = *plan.scene;
  const std::size_t pose_bytes = sizeof(float) * PoseSpan::floats_for(plan.assets.joint_count());
  const std::size_t extra_layers = plan.blend ? plan.needs.max_layers - 1 : 0;
  const std::size_t numbers = plan.properties ? scene.properties.rest.size() : 0;
  BlockLayout block;
  lay_out_front(plan, pose_bytes, numbers, block);
  plan.layout.rest_pose_at = block.take(pose_bytes);
  if (!plan.sample) plan.layout.pose_at = plan.layout.rest_pose_at;
  plan.layout.layer_poses_at = block.take(extra_layers * pose_bytes);
  plan.layout.layer_weights_at = block.take_array<float>(extra_layers * scene.weight_count());
  plan.layout.layer_properties_at = block.take_array<float>(extra_layers * numbers);
  plan.layout.unmirrored_pose_at = block.take(plan.mirror ? pose_bytes : 0);
  plan.layout.unmirrored_weights_at = block.take_array<float>(plan.mirror ? scene.weight_count() : 0);
  if (plan.correctives)
    for (const PoseCorrective& corrective : plan.assets.correctives)
      plan.layout.corrective_scratch_count = std::max(plan.layout.corrective_scratch_count, scratch_size(corrective));
  plan.layout.corrective_scratch_at = block.take_array<double>(plan.layout.corrective_scratch_count);
  plan.layout.added_pose_at = block.take(plan.add ? pose_bytes : 0);
  plan.layout.reference_pose_at = block.take(plan.add ? pose_bytes : 0);
  plan.layout.added_weights_at = block.take_array<float>(plan.add ? scene.weight_count() : 0);
  plan.layout.reference_weights_at = block.take_array<float>(plan.add ? scene.weight_count() : 0);
  if (plan.interpolate)
    for (PoseLayout& update : plan.layout.updates)
      update = {block.take(pose_bytes), block.take_array<float>(scene.weight_count()),
                block.take_array<float>(numbers)};
  lay_out_primitives(plan, block);
  lay_out_geometry(plan, block);
  plan.layout.frame_bytes = block.size();
}

}  // namespace sinew
