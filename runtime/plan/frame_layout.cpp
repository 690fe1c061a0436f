// SPDX-License-Identifier: MIT
#include "runtime/plan/frame_layout.h"

#include <algorithm>

#include "runtime/deform/surface_normals.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/frame_tables.h"
#include "runtime/plan/pose_operations.h"
#include "runtime/pose/correct_pose.h"

namespace sinew {
namespace {

/// Hands out parts of one memory, each on cache lines of its own.
class MemoryLayout {
 public:
  template <class T>
  Block<T> take(std::size_t count) noexcept {
    const Block<T> block{end_, count};
    end_ += (count * sizeof(T) + kAlignment - 1) / kAlignment * kAlignment;
    return block;
  }
  std::size_t size() const noexcept { return end_; }

 private:
  static constexpr std::size_t kAlignment = 64;
  std::size_t end_ = 0;
};

/// Takes memory for poses, morph weights and properties. All poses of a plan have the same size.
class PoseMaker {
 public:
  PoseMaker(const CompiledPlan& plan, MemoryLayout& memory)
      : memory_(memory),
        joints_(plan.assets.joint_count()),
        weights_(plan.scene->weight_count()),
        properties_(plan.properties ? plan.scene->properties.rest.size() : 0) {}

  PoseBlock pose() { return {memory_.take<float>(floats()), joints_}; }
  Block<float> weights() { return memory_.take<float>(weights_); }
  Block<float> properties() { return memory_.take<float>(properties_); }

 private:
  std::size_t floats() const noexcept { return PoseSpan::floats_for(joints_); }

  MemoryLayout& memory_;
  std::size_t joints_, weights_, properties_;
};

/// Vertices between two stages, which primitives share since they run one after another.
class SharedVertices {
 public:
  void need(const AttributeSet& set, std::size_t count) {
    if (set.positions) positions_ = std::max(positions_, count);
    if (set.normals) normals_ = std::max(normals_, count);
    if (set.tangents) tangents_ = std::max(tangents_, count);
  }
  VertexBlocks take(MemoryLayout& memory) const {
    VertexBlocks blocks;
    blocks.positions = memory.take<glm::vec3>(positions_);
    blocks.normals = memory.take<glm::vec3>(normals_);
    blocks.tangents = memory.take<glm::vec4>(tangents_);
    return blocks;
  }
  /// Memory for counts that are those of tiles.
  TiledBlocks take_tiles(MemoryLayout& memory) const {
    TiledBlocks blocks;
    blocks.positions = memory.take<TilePlane>(3 * positions_);
    blocks.normals = memory.take<TilePlane>(3 * normals_);
    blocks.tangents = memory.take<TilePlane>(4 * tangents_);
    return blocks;
  }

 private:
  std::size_t positions_ = 0, normals_ = 0, tangents_ = 0;
};

void lay_out_primitives(CompiledPlan& plan, MemoryLayout& memory) {
  SharedVertices morphed, morphed_tiles;
  std::size_t scratch = 0;
  for (std::size_t i = 0; i < plan.primitives.size(); ++i) {
    const PrimitivePlan& p = plan.primitives[i];
    const PrimitiveSkinning& skinning = plan.primitive_skinning[i];
    VertexBlocks& blocks = plan.layout.primitives.emplace_back();
    const std::size_t count = primitive_of(plan, p).vertex_count();
    if (p.morph.positions || p.skin.positions || p.cached.positions) blocks.positions = memory.take<glm::vec3>(count);
    if (p.morph.normals || p.skin.normals || p.cached.normals || p.flat_normals)
      blocks.normals = memory.take<glm::vec3>(count);
    if (p.morph.tangents || p.skin.tangents || p.cached.tangents) blocks.tangents = memory.take<glm::vec4>(count);
    if (p.morph_colors) blocks.colors = memory.take<glm::vec4>(count);
    if (skinning.morphs != nullptr) {
      morphed_tiles.need(p.morph, skinning.tiles->tile_count());
      continue;
    }
    if (p.skin.any()) morphed.need(p.morph, count);
    if (p.morph.any()) scratch = std::max(scratch, count);
  }
  plan.layout.morphed = morphed.take(memory);
  plan.layout.morphed_tiles = morphed_tiles.take_tiles(memory);
  plan.layout.morph_scratch = memory.take<glm::vec3>(scratch);
}

void lay_out_geometry(CompiledPlan& plan, MemoryLayout& memory) {
  SharedVertices cached;
  std::size_t sums = 0;
  for (std::size_t p = 0; p < plan.primitives.size(); ++p) {
    cached.need(plan.primitives[p].cached, primitive_of(plan, plan.primitives[p]).vertex_count());
    if (plan.surface_faces[p] != nullptr) sums = std::max(sums, surface_sums(*plan.surface_faces[p]));
  }
  plan.layout.cached = cached.take(memory);
  plan.layout.surface_sums = memory.take<glm::vec4>(sums);
}

void lay_out_tables(CompiledPlan& plan, MemoryLayout& memory) {
  const std::size_t instances = plan.scene->instances.size(), weights = plan.scene->weight_count(),
                    slots = plan.geometry_slot.empty() ? 0 : plan.needs.in.cached_instances.size();
  TableLayout& tables = plan.layout.tables;
  tables.instances = memory.take<InstanceResult>(instances);
  tables.primitives = memory.take<DeformedPrimitive>(plan.primitives.size());
  tables.palettes = memory.take<SkinPalette>(plan.palette.size());
  tables.weights_since = memory.take<std::uint64_t>(instances);
  tables.winding_since = memory.take<std::uint64_t>(instances);
  tables.last_weights = memory.take<float>(weights);
  tables.input_weights = memory.take<float>(weights);
  tables.input_out_of_view = memory.take<std::uint8_t>(instances);
  tables.stage_ns = memory.take<std::uint64_t>(plan.needs.out.stage_times ? kStageCount : 0);
  tables.shown = memory.take<ShownVertices>(slots);
  tables.played = memory.take<PlayedGeometry>(slots);
  tables.geometry_since = memory.take<std::uint64_t>(slots);
  tables.input_geometry = memory.take<GeometryInput>(slots);
  tables.input_program = memory.take<PoseOp>(plan.needs.in.program.ops);
  tables.input_versions = memory.take<ContentVersion>(most_versions(plan.needs.in.program));
  tables.kept = memory.take<KeptOperands>(plan.needs.in.program.kept);
  tables.input_layers = memory.take<ClipLayer>(plan.needs.in.layer_room());
  if (!plan.interpolate) return;
  tables.input_next_layers = memory.take<ClipLayer>(plan.needs.in.layer_room());
  tables.updates = memory.take<KeptUpdate>(2);
  for (Block<ClipLayer>& layers : tables.update_layers) layers = memory.take<ClipLayer>(plan.needs.in.layer_room());
}

/// The front of the memory: frames of one clip touch it before vertices.
void lay_out_front(CompiledPlan& plan, PoseMaker& make, MemoryLayout& memory) {
  const Scene& scene = *plan.scene;
  FrameLayout& layout = plan.layout;
  lay_out_tables(plan, memory);
  if (plan.poses) layout.pose.pose = make.pose();
  layout.pose.weights = make.weights();
  layout.pose.properties = make.properties();
  layout.hidden = memory.take<bool>(plan.hide ? scene.skeleton.joint_count() : 0);
  layout.palette_wanted = memory.take<bool>(scene.skins.size());
  layout.model = memory.take<Affine>(plan.local_to_model ? plan.assets.joint_count() : 0);
  for (std::size_t s = 0; s < scene.skins.size(); ++s) {
    layout.palettes.push_back(memory.take<JointMatrix>(plan.palette[s] ? matrix_count(plan, s) : 0));
    layout.splits.push_back(memory.take<RigidStretch>(plan.split[s] ? scene.skins[s].joints.size() : 0));
  }
  layout.stretch = memory.take<bool>(scene.skins.size());
  layout.front_bytes = memory.size();
  if (!plan.poses) return;
  layout.pose_slots = PoseSlotLayout(plan.pose_assets, pose_room(plan));
  layout.pose_program = memory.take<std::byte>(layout.pose_slots.bytes);
  layout.front_bytes += layout.pose_slots.front_bytes;
}

std::size_t most_corrective_scratch(const CompiledPlan& plan) {
  std::size_t most = 0;
  if (plan.correctives)
    for (const PoseCorrective& corrective : plan.assets.correctives) most = std::max(most, scratch_size(corrective));
  return most;
}

}  // namespace

void lay_out_frame(CompiledPlan& plan) {
  FrameLayout& layout = plan.layout;
  MemoryLayout memory;
  PoseMaker make(plan, memory);
  lay_out_front(plan, make, memory);
  layout.rest_pose = make.pose();
  if (!plan.poses) layout.pose.pose = layout.rest_pose;
  layout.corrective_scratch = memory.take<double>(most_corrective_scratch(plan));
  if (plan.interpolate)
    for (PoseBlocks& update : layout.updates) update = {make.pose(), make.weights(), make.properties()};
  lay_out_primitives(plan, memory);
  lay_out_geometry(plan, memory);
  layout.frame_bytes = memory.size();
}

}  // namespace sinew
