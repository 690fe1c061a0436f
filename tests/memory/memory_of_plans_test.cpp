// SPDX-License-Identifier: MIT
// Every array of a plan is counted, to the byte.
#include <gtest/gtest.h>

#include <memory>

#include "runtime/memory/memory_of.h"
#include "runtime/plan/compiled_plan.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

constexpr std::size_t kMore = 13;

/// A plan whose arrays can be changed. Copies of arrays have no spare capacity.
class MemoryOfPlans : public testing::Test {
 protected:
  static std::size_t bytes(const CompiledPlan& plan) {
    return memory_of(Plan(std::make_shared<const CompiledPlan>(plan))).plans;
  }

  /// The number of bytes that a change adds.
  template <class Change>
  std::size_t added_by(const Change& change) const {
    CompiledPlan plan = plan_;
    change(plan);
    return bytes(plan) - bytes(plan_);
  }

  /// Expects that elements added to an array are counted with their size.
  /// in   array_of   function from CompiledPlan& to the array
  template <class ArrayOf>
  void expect_counted(const char* name, const ArrayOf& array_of) const {
    std::size_t size = 0;
    const std::size_t added = added_by([&](CompiledPlan& plan) {
      auto& array = array_of(plan);
      array.resize(array.size() + kMore);
      size = sizeof(array[0]);
    });
    EXPECT_EQ(added, kMore * size) << name;
  }

  const Scene scene_ = arm_scene();
  const CompiledPlan plan_ = *compile_plan(lend(scene_), Needs{}).compiled();
};

#define EXPECT_COUNTED(array) \
  expect_counted(             \
      #array, [](CompiledPlan & plan) -> auto& { return plan.array; })

TEST_F(MemoryOfPlans, tables_of_poses_and_primitives) {
  EXPECT_COUNTED(clip_tracks);
  EXPECT_COUNTED(moved_joints);
  EXPECT_COUNTED(joint_scales);
  EXPECT_COUNTED(masks);
  EXPECT_COUNTED(rest_weights);
  EXPECT_COUNTED(primitives);
  EXPECT_COUNTED(primitive_skinning);
  EXPECT_COUNTED(flat_faces);
  EXPECT_COUNTED(surface_faces);
  EXPECT_COUNTED(first_primitive);
  EXPECT_COUNTED(geometry_slot);
  EXPECT_COUNTED(instance_scales);
  EXPECT_COUNTED(combined);
  EXPECT_COUNTED(hemisphere_edges);
  EXPECT_COUNTED(layout.palettes);
  EXPECT_COUNTED(layout.splits);
  EXPECT_COUNTED(layout.primitives);
  EXPECT_COUNTED(assets.skins);
}

TEST_F(MemoryOfPlans, what_the_needs_hold_and_the_tables_of_a_mirror) {
  EXPECT_COUNTED(needs.in.masks);
  EXPECT_COUNTED(needs.out.skeleton_lod.held);
  EXPECT_COUNTED(needs.in.cached_instances);
  EXPECT_COUNTED(needs.skin.per_instance);
  EXPECT_COUNTED(mirror_tables.copies);
  EXPECT_COUNTED(mirror_tables.translation.joints);
  EXPECT_COUNTED(mirror_tables.translation.sources);
  EXPECT_COUNTED(mirror_tables.translation.factors);
  EXPECT_COUNTED(mirror_tables.rotation.joints);
  EXPECT_COUNTED(mirror_tables.rotation.sources);
  EXPECT_COUNTED(mirror_tables.rotation.factors);
  EXPECT_COUNTED(mirror_tables.scale.joints);
  EXPECT_COUNTED(mirror_tables.scale.sources);
  EXPECT_COUNTED(mirror_tables.scale.factors);
}

TEST_F(MemoryOfPlans, flags_count_by_the_bit) {
  constexpr std::size_t kBits = 1 << 16;
  const auto expect_bits = [&](auto array_of) {
    std::size_t before = 0;
    const std::size_t added = added_by([&](CompiledPlan& plan) {
      before = std::vector<bool>(array_of(plan)).capacity();
      array_of(plan).assign(kBits, true);
    });
    EXPECT_EQ(added, (kBits - before) / 8);
  };
  expect_bits([](CompiledPlan & plan) -> auto& { return plan.instance_skinned; });
  expect_bits([](CompiledPlan & plan) -> auto& { return plan.palette; });
  expect_bits([](CompiledPlan & plan) -> auto& { return plan.split; });
  expect_bits([](CompiledPlan & plan) -> auto& { return plan.needs.out.skeleton_lod.kept; });
}

TEST_F(MemoryOfPlans, arrays_in_arrays) {
  const std::vector<float> five(5);
  const std::size_t of_mask = sizeof five + 5 * sizeof(float);
  EXPECT_EQ(added_by([&](CompiledPlan& plan) { plan.mask_weights = {five, five}; }), 2 * of_mask);
  EXPECT_EQ(added_by([&](CompiledPlan& plan) { plan.needs.in.masks = {five}; }), of_mask);
  EXPECT_EQ(added_by([&](CompiledPlan& plan) { plan.primitive_skinning.at(0).pairs.resize(7); }),
            7 * sizeof(JointPair));
  const std::size_t edges = plan_.hemisphere_edges.size();
  EXPECT_EQ(added_by([&](CompiledPlan& plan) {
              plan.hemisphere_edges.resize(edges + 1);
              plan.hemisphere_edges.back().resize(3);
            }),
            sizeof(std::vector<JointPair>) + 3 * sizeof(JointPair));
  const auto of_combined = [&](VertexInfluences CombinedInfluences::*part) {
    return added_by([&](CompiledPlan& plan) {
      plan.combined.resize(plan_.combined.size() + 1);
      (plan.combined.back().emplace_back().*part) = {{{0, 1, 1, 0}}, {1, 2, 3}, {0.5f, 0.5f}};
    });
  };
  const std::size_t parts = sizeof(std::vector<CombinedInfluences>) + sizeof(CombinedInfluences) +
                            sizeof(InfluenceGroup) + 3 * sizeof(std::uint16_t) + 2 * sizeof(float);
  EXPECT_EQ(of_combined(&CombinedInfluences::combinations), parts);
  EXPECT_EQ(of_combined(&CombinedInfluences::vertices), parts);
}

TEST_F(MemoryOfPlans, what_several_share_counts_once) {
  FlatFaces flat;
  flat.streams.resize(2);
  flat.corners.resize(3);
  flat.alone.resize(6);
  flat.at_rest.resize(9);
  const auto shared_flat = std::make_shared<const FlatFaces>(flat);
  EXPECT_EQ(added_by([&](CompiledPlan& plan) {
              plan.flat_faces = {shared_flat, nullptr, shared_flat};
            }) + plan_.flat_faces.size() * sizeof(shared_flat),
            3 * sizeof(shared_flat) + sizeof flat + 2 * sizeof(FlatStream) + 18 * sizeof(std::uint32_t));
  SurfaceFaces surface;
  surface.corners.resize(3);
  surface.point_of_vertex.resize(6);
  surface.tangents.resize(3);
  const auto shared_surface = std::make_shared<const SurfaceFaces>(surface);
  EXPECT_EQ(added_by([&](CompiledPlan& plan) {
              plan.surface_faces = {shared_surface, shared_surface};
            }) + plan_.surface_faces.size() * sizeof(shared_surface),
            2 * sizeof(shared_surface) + sizeof surface + 9 * sizeof(std::uint32_t) + 3 * sizeof(glm::vec2));
  VertexTiles tiles;
  tiles.runs.resize(2);
  tiles.joints.resize(3);
  tiles.positions.resize(3);
  tiles.weights.resize(2);
  tiles.normals.resize(3);
  tiles.tangents.resize(4);
  tiles.vertices.resize(16);
  tiles.fours.resize(4);
  const auto shared_tiles = std::make_shared<const VertexTiles>(tiles);
  EXPECT_EQ(added_by([&](CompiledPlan& plan) {
              PrimitiveSkinning skinning;
              skinning.tiles = shared_tiles;
              plan.primitive_skinning = {skinning, {}, skinning};
            }) + plan_.primitive_skinning.size() * sizeof(PrimitiveSkinning),
            3 * sizeof(PrimitiveSkinning) + sizeof tiles + 2 * sizeof(TileRun) + 3 * sizeof(std::uint16_t) +
                12 * sizeof(TilePlane) + 20 * sizeof(std::uint32_t));
  TiledMorphs morphs;
  morphs.targets.resize(2);
  morphs.targets[0].positions = {std::vector<std::uint32_t>(1), std::vector<TilePlane>(3)};
  morphs.targets[1].normals = {std::vector<std::uint32_t>(2), std::vector<TilePlane>(6)};
  morphs.targets[1].tangents = {std::vector<std::uint32_t>(3), std::vector<TilePlane>(9)};
  const auto shared_morphs = std::make_shared<const TiledMorphs>(morphs);
  EXPECT_EQ(added_by([&](CompiledPlan& plan) {
              PrimitiveSkinning skinning;
              skinning.morphs = shared_morphs;
              plan.primitive_skinning = {skinning, {}, skinning};
            }) + plan_.primitive_skinning.size() * sizeof(PrimitiveSkinning),
            3 * sizeof(PrimitiveSkinning) + sizeof morphs + 2 * sizeof(TiledTarget) + 6 * sizeof(std::uint32_t) +
                18 * sizeof(TilePlane));
  MirrorMap map;
  map.joints.resize(2);
  map.unpaired.resize(3);
  map.weight_source.resize(4);
  const auto shared_map = std::make_shared<const MirrorMap>(map), other = std::make_shared<const MirrorMap>(map);
  const std::size_t of_map = sizeof map + 2 * sizeof(MirroredJoint) + 7 * sizeof(std::uint32_t);
  EXPECT_EQ(added_by([&](CompiledPlan& plan) { plan.needs.in.mirror = plan.assets.mirror = shared_map; }), of_map);
  EXPECT_EQ(added_by([&](CompiledPlan& plan) {
              plan.needs.in.mirror = shared_map;
              plan.assets.mirror = other;
            }),
            2 * of_map);
}

TEST_F(MemoryOfPlans, the_plan_itself_and_reduced_copies_of_assets) {
  CompiledPlan empty;
  empty.scene = lend(scene_);
  empty.assets.skeleton = &scene_.skeleton;
  EXPECT_EQ(memory_of(Plan(std::make_shared<const CompiledPlan>(empty))).total(), sizeof(CompiledPlan));
  Skeleton fewer = scene_.skeleton;
  Skin skin;
  skin.joints.resize(3);
  skin.inverse_bind.resize(3);
  empty.assets.skeleton = &fewer;
  empty.assets.joint_map.resize(scene_.skeleton.joint_count() + 1);
  empty.assets.skins = {&skin, &skin};
  const MemoryBytes bytes = memory_of(Plan(std::make_shared<const CompiledPlan>(empty)));
  EXPECT_EQ(bytes.plans,
            sizeof(CompiledPlan) + empty.assets.joint_map.size() * sizeof(JointMapping) + 2 * sizeof(Skin*));
  EXPECT_EQ(bytes.skins, 2 * 3 * (sizeof(skin.joints[0]) + sizeof(skin.inverse_bind[0])));
  EXPECT_EQ(bytes.skeletons, memory_of(fewer).skeletons);
  EXPECT_EQ(bytes.total(), bytes.plans + bytes.skins + bytes.skeletons + memory_of(fewer).others);
}

}  // namespace
}  // namespace sinew::test
