// SPDX-License-Identifier: MIT
// Intermediate images are recreated only on changes; pipelines are shared if their shaders are the same.
#include "viewer/passes/pass_resources.h"

#include <functional>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

#include "tests/viewer/device_fixture.h"

namespace sinew::viewer {
namespace {

/// An image and whether a graph needs it.
struct Wanted {
  Target target;
  bool wanted;
};
std::vector<Wanted> wanted_by(const FrameGraph& graph) {
  return {{Target::depth, graph.depth_image},     {Target::normals, graph.normal_image},
          {Target::ao, graph.ao_image},           {Target::half_blurred_ao, graph.half_blurred_ao},
          {Target::color, graph.color_image},     {Target::shadow, graph.shadow_maps > 0},
          {Target::color_samples, graph.sampled}, {Target::depth_samples, graph.sampled}};
}

class frame_targets : public DeviceTest {
 protected:
  static std::vector<VkImageView> views(const FrameTargets& targets) {
    std::vector<VkImageView> out;
    for (const Wanted& w : wanted_by(FrameGraph({}))) out.push_back(targets.view(w.target));
    return out;
  }
};

TEST_F(frame_targets, the_shadow_image_has_a_tile_for_each_light_that_casts_shadows) {
  FrameTargets targets(*test_device(), 2);
  for (const std::uint32_t maps : {1u, 2u, 3u, 4u}) {
    targets.fit(FrameGraph({.opaque = true, .shadows = maps}), {64, 48});
    const VkImageView view = targets.view(Target::shadow), color = targets.view(Target::color);
    targets.fit(FrameGraph({.opaque = true, .shadows = maps}), {64, 48});
    EXPECT_EQ(targets.view(Target::shadow), view) << "nothing has changed";
    EXPECT_EQ(targets.view(Target::color), color);
  }
  for (const auto& [maps, columns, rows] : {std::tuple(1u, 1u, 1u), {2u, 2u, 1u}, {3u, 2u, 2u}, {4u, 2u, 2u}}) {
    EXPECT_EQ(ShadowTiles(maps).columns, columns);
    EXPECT_EQ(ShadowTiles(maps).rows, rows);
  }
}

TEST_F(frame_targets, exist_exactly_where_the_graph_needs_them_and_stay_while_it_does) {
  FrameTargets targets(*test_device(), 2);
  const VkImageView nothing = targets.view(Target::color);
  std::vector<VkImageView> before = views(targets);
  for (const FrameNeeds& needs :
       {FrameNeeds{.opaque = true}, FrameNeeds{.opaque = true}, FrameNeeds{.opaque = true, .blur = false},
        FrameNeeds{.opaque = true, .show = Show::depth}, FrameNeeds{.opaque = true, .occlusion = false},
        FrameNeeds{.opaque = true, .show = Show::normals}, FrameNeeds{.opaque = true, .shadows = true},
        FrameNeeds{.opaque = true, .smooth_edges = true}, FrameNeeds{.opaque = true}}) {
    const FrameGraph graph(needs);
    targets.fit(graph, {64, 48});
    const std::vector<VkImageView> now = views(targets);
    const std::vector<Wanted> all = wanted_by(graph);
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(targets.exists(all[i].target), all[i].wanted) << i;
      EXPECT_EQ(now[i] == nothing, !all[i].wanted) << "a black texel stands in";
      if (before[i] != nothing && all[i].wanted) {
        EXPECT_EQ(now[i], before[i]) << "it was there already";
      }
    }
    before = now;
  }
}

TEST_F(frame_targets, are_made_anew_when_either_side_changes) {
  FrameTargets targets(*test_device(), 1);
  const FrameGraph graph({.opaque = true});
  targets.fit(graph, {64, 48});
  for (const VkExtent2D& extent : {VkExtent2D{80, 48}, VkExtent2D{80, 60}, VkExtent2D{10, 10}}) {
    targets.fit(graph, extent);
    EXPECT_EQ(targets.extent().width, extent.width);
    EXPECT_EQ(targets.extent().height, extent.height);
    const auto there = views(targets);
    targets.fit(graph, extent);
    EXPECT_EQ(views(targets), there);
  }
}

TEST_F(frame_targets, of_occlusion_are_the_picture_divided_by_the_step_rounded_up) {
  for (const std::uint32_t step : {1u, 2u, 3u}) {
    FrameTargets targets(*test_device(), step);
    targets.fit(FrameGraph({.opaque = true}), {7, 12});
    EXPECT_EQ(targets.ao_extent().width, step == 1 ? 7u : step == 2 ? 4u : 3u);
    EXPECT_EQ(targets.ao_extent().height, 12u / step);
  }
}

class pass_pipelines : public DeviceTest {
 protected:
  void SetUp() override {
    DeviceTest::SetUp();
    if (!test_device()) return;
    layouts_ = std::make_unique<PassLayouts>(*test_device());
    pipelines_ = std::make_unique<PassPipelines>(*test_device(), *layouts_, VK_FORMAT_R8G8B8A8_UNORM, OcclusionShape{});
  }
  void TearDown() override {
    pipelines_.reset();
    layouts_.reset();
    DeviceTest::TearDown();
  }

  using Change = std::function<void(MeshPipelineKey&)>;

  /// True if a change of the key gives the same pipeline.
  bool shared(MeshPipelineKey key, const Change& change) {
    const VkPipeline before = pipelines_->mesh(key);
    EXPECT_EQ(pipelines_->mesh(key), before);
    change(key);
    return pipelines_->mesh(key) == before;
  }

  std::unique_ptr<PassLayouts> layouts_;
  std::unique_ptr<PassPipelines> pipelines_;
};

/// The key of a surface with all features.
MeshPipelineKey full_key(Pass pass) {
  MeshPipelineKey key;
  key.pass = pass;
  key.frame = {.occluded = true, .ambient = true, .light_count = 2};
  key.surface.normals = NormalSource::vertices;
  key.surface.tangents = true;
  key.surface.material.texcoord_sets = {1, 1, 1, 1, 1};
  key.surface.material.layers = {.specular = true, .textures = {3, 5}};
  return key;
}

TEST_F(pass_pipelines, what_screens_use_alone_makes_no_other_pipeline_for_meshes) {
  for (const Pass pass : {Pass::normal_depth, Pass::opaque, Pass::transparent}) {
    EXPECT_TRUE(shared(full_key(pass), [](auto& k) { k.frame.transparent_background = true; }));
    EXPECT_TRUE(shared(full_key(pass), [](auto& k) { k.frame.tone_curve = ToneCurve::aces; }));
    EXPECT_TRUE(shared(full_key(pass), [](auto& k) { k.frame.backdrop = Backdrop::sharp; }));
    EXPECT_FALSE(shared(full_key(pass), [](auto& k) { k.frame.parallel = true; }));
    EXPECT_FALSE(shared(full_key(pass), [](auto& k) { k.masked = true; }));
    EXPECT_FALSE(shared(full_key(pass), [](auto& k) { k.topology = Topology::lines; }));
  }
}

TEST_F(pass_pipelines, gooch_shading_reads_base_colours_alone_and_is_not_of_the_prepass) {
  EXPECT_TRUE(shared(full_key(Pass::normal_depth), [](auto& k) { k.frame.gooch = true; }));
  EXPECT_FALSE(shared(full_key(Pass::opaque), [](auto& k) { k.frame.gooch = true; }));
  MeshPipelineKey key = full_key(Pass::opaque);
  key.frame.gooch = true;
  EXPECT_TRUE(shared(key, [](auto& k) { k.frame.light_count = 1; }));
  EXPECT_TRUE(shared(key, [](auto& k) { k.surface.material.layers = {}; }));
  EXPECT_TRUE(shared(key, [](auto& k) { k.surface.tangents = false; })) << "no normal map acts on tones";
  for (const std::size_t slot : {1u, 2u, 3u, 4u})
    EXPECT_TRUE(shared(key, [&](auto& k) { k.surface.material.texcoord_sets[slot] = 0; })) << slot;
  EXPECT_FALSE(shared(key, [](auto& k) { k.surface.material.texcoord_sets[0] = 0; }));
}

TEST_F(pass_pipelines, the_prepass_knows_neither_light_nor_colours_unless_it_cuts_by_alpha) {
  const MeshPipelineKey key = full_key(Pass::normal_depth);
  EXPECT_TRUE(shared(key, [](auto& k) { k.frame.occluded = k.frame.ambient = false; }));
  EXPECT_TRUE(shared(key, [](auto& k) { k.frame.light_count = 0; }));
  EXPECT_TRUE(shared(key, [](auto& k) { k.surface.material.unlit = true; }));
  for (const std::size_t slot : {0u, 1u, 3u, 4u})
    EXPECT_TRUE(shared(key, [&](auto& k) { k.surface.material.texcoord_sets[slot] = 2; })) << slot;
  EXPECT_TRUE(shared(key, [](auto& k) { k.surface.material.layers = {}; }));
  EXPECT_FALSE(shared(key, [](auto& k) { k.surface.material.texcoord_sets[2] = 0; })) << "its normal map";
  EXPECT_FALSE(shared(key, [](auto& k) { k.surface.tangents = false; }));
  EXPECT_FALSE(shared(key, [](auto& k) { k.surface.normals = NormalSource::none; }));
  EXPECT_FALSE(shared(key, [](auto& k) { k.depth_only = true; }));
  MeshPipelineKey masked = key;
  masked.masked = true;
  EXPECT_FALSE(shared(masked, [](auto& k) { k.surface.material.texcoord_sets[0] = 2; })) << "its alpha";
  MeshPipelineKey depth = key;
  depth.depth_only = true;
  EXPECT_TRUE(shared(depth, [](auto& k) { k.surface.normals = NormalSource::none; }));
  EXPECT_TRUE(shared(depth, [](auto& k) { k.surface.material.texcoord_sets[2] = 0; })) << "nothing reads normals";
  EXPECT_TRUE(shared(depth, [](auto& k) { k.surface.tangents = false; }));
}

TEST_F(pass_pipelines, what_filters_the_light_behind_knows_no_light_of_its_own) {
  for (const Through step : {Through::filter, Through::filter_drawn, Through::blurred_backdrop, Through::erase}) {
    MeshPipelineKey key = full_key(Pass::transparent);
    key.through = step;
    EXPECT_TRUE(shared(key, [](auto& k) { k.frame.light_count = 1; }));
    EXPECT_TRUE(shared(key, [](auto& k) { k.frame.ambient = false; }));
    EXPECT_TRUE(shared(key, [](auto& k) { k.surface.material.texcoord_sets[4] = 0; })) << "nothing is emitted";
    EXPECT_FALSE(shared(key, [](auto& k) { k.surface.material.texcoord_sets[0] = 0; }));
    EXPECT_FALSE(shared(key, [](auto& k) { k.surface.material.layers.clearcoat = true; }));
  }
}

TEST_F(pass_pipelines, shading_uses_all_of_a_surface) {
  const MeshPipelineKey key = full_key(Pass::opaque);
  EXPECT_FALSE(shared(key, [](auto& k) { k.frame.occluded = false; }));
  EXPECT_FALSE(shared(key, [](auto& k) { k.frame.ambient = false; }));
  EXPECT_FALSE(shared(key, [](auto& k) { k.frame.light_count = 0; }));
  EXPECT_FALSE(shared(key, [](auto& k) { k.after_prepass = true; }));
  EXPECT_FALSE(shared(key, [](auto& k) { k.surface.tangents = false; }));
  for (const std::size_t slot : {0u, 1u, 2u, 3u, 4u})
    EXPECT_FALSE(shared(key, [&](auto& k) { k.surface.material.texcoord_sets[slot] = 2; })) << slot;
  EXPECT_FALSE(shared(key, [](auto& k) { k.surface.material.layers.specular = false; }));
  EXPECT_FALSE(shared(key, [](auto& k) { k.surface.material.layers.clearcoat = true; }));
  EXPECT_FALSE(shared(key, [](auto& k) { k.surface.material.layers.sheen = true; }));
  EXPECT_FALSE(shared(full_key(Pass::transparent), [](auto& k) { k.through = Through::light; }));
  MeshPipelineKey frosted = full_key(Pass::transparent);
  frosted.through = Through::frosted_sharp;
  EXPECT_FALSE(shared(frosted, [](auto& k) { k.frame.light_count = 0; })) << "its light is drawn in the same step";
  EXPECT_FALSE(shared(frosted, [](auto& k) { k.through = Through::frosted_blurred; }));
  EXPECT_FALSE(shared(full_key(Pass::transparent), [](auto& k) { k.covers = true; }));
  EXPECT_FALSE(shared(key, [](auto& k) { k.surface.material.layers.textures[1] = 0; }));
  EXPECT_TRUE(shared(full_key(Pass::transparent), [](auto& k) { k.frame.occluded = false; }))
      << "blended surfaces take no occlusion";
  MeshPipelineKey flat = key;
  flat.surface.material.texcoord_sets[2] = 0;
  EXPECT_TRUE(shared(flat, [](auto& k) { k.surface.tangents = false; })) << "without a normal map";
  flat.surface.material.layers.textures[kClearcoatNormal] = 1;
  EXPECT_FALSE(shared(flat, [](auto& k) { k.surface.tangents = false; })) << "the clear layer has one";
}

TEST_F(pass_pipelines, unlit_surfaces_have_a_base_colour_alone) {
  MeshPipelineKey key = full_key(Pass::opaque);
  key.surface.material.unlit = true;
  for (const std::size_t slot : {1u, 2u, 3u, 4u})
    EXPECT_TRUE(shared(key, [&](auto& k) { k.surface.material.texcoord_sets[slot] = 0; })) << slot;
  EXPECT_TRUE(shared(key, [](auto& k) { k.surface.material.layers = {}; }));
  EXPECT_FALSE(shared(key, [](auto& k) { k.surface.material.texcoord_sets[0] = 0; }));
  EXPECT_TRUE(shared(key, [](auto& k) { k.surface.normals = NormalSource::none; }));
  EXPECT_TRUE(shared(key, [](auto& k) { k.frame = {}; })) << "no light reaches them";
  EXPECT_FALSE(shared(key, [](auto& k) { k.surface.material.unlit = false; }));
}

TEST_F(pass_pipelines, each_screen_has_its_own_and_is_made_once) {
  std::set<VkPipeline> made;
  const Pass passes[] = {Pass::ssao, Pass::blur_horizontal, Pass::blur_vertical, Pass::tonemap, Pass::overlay};
  for (const Pass pass : passes) made.insert(pipelines_->screen({.pass = pass}));
  for (const Show show : {Show::ao, Show::normals, Show::depth, Show::level})
    made.insert(pipelines_->screen({.pass = Pass::show, .show = show}));
  EXPECT_EQ(made.size(), 9u);
  for (const Pass pass : passes) EXPECT_EQ(made.count(pipelines_->screen({.pass = pass})), 1u);
}

}  // namespace
}  // namespace sinew::viewer
