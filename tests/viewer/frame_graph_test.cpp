// SPDX-License-Identifier: MIT
#include "viewer/passes/frame_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "viewer/passes/pass_stages.h"

namespace sinew::viewer {
namespace {

using testing::ElementsAre;

std::vector<Pass> passes(const FrameNeeds& needs) {
  const FrameGraph graph(needs);
  return {graph.begin(), graph.end()};
}

TEST(frame_graph, runs_every_pass_in_order_when_everything_is_needed) {
  EXPECT_THAT(passes({.opaque = true, .blended = true, .overlay = true}),
              ElementsAre(Pass::normal_depth, Pass::ssao, Pass::blur_horizontal, Pass::blur_vertical, Pass::opaque,
                          Pass::transparent, Pass::tonemap, Pass::overlay));
}

TEST(frame_graph, P15_has_no_pass_for_lines_that_nobody_asks_for) {
  const FrameNeeds shown{.opaque = true, .occlusion = false};
  EXPECT_THAT(passes(shown), ElementsAre(Pass::opaque, Pass::tonemap));
  EXPECT_EQ(describe_passes(shown, {})[static_cast<std::size_t>(Pass::overlay)].reason, "no lines are asked for");
}

TEST(frame_graph, P17_has_no_occlusion_passes_or_images_when_occlusion_is_off_or_there_is_no_ambient_light) {
  for (const FrameNeeds& needs :
       {FrameNeeds{.opaque = true, .occlusion = false}, FrameNeeds{.opaque = true, .ambient = false}}) {
    const FrameGraph graph(needs);
    EXPECT_THAT(passes(needs), ElementsAre(Pass::opaque, Pass::tonemap));
    EXPECT_FALSE(graph.ao_image || graph.half_blurred_ao || graph.normal_image);
    EXPECT_TRUE(graph.depth_image && graph.color_image);
  }
}

TEST(frame_graph, has_bent_normals_only_where_horizons_are_found_and_a_picture_reflects_ambient_light) {
  const FrameNeeds lit{.opaque = true, .horizons = true};
  EXPECT_TRUE(FrameGraph(lit).bent_normals);
  for (const FrameNeeds& needs :
       {FrameNeeds{.opaque = true}, FrameNeeds{.opaque = true, .ambient = false, .horizons = true},
        FrameNeeds{.opaque = true, .occlusion = false, .horizons = true}, FrameNeeds{.blended = true, .horizons = true},
        FrameNeeds{.opaque = true, .horizons = true, .show = Show::ao}})
    EXPECT_FALSE(FrameGraph(needs).bent_normals);
  const auto reason_of = [](const FrameNeeds& needs) {
    return describe_passes(needs, {})[static_cast<std::size_t>(Pass::ssao)].reason;
  };
  EXPECT_EQ(reason_of(lit), "ambient occlusion is on; reflections read bent normals");
  EXPECT_EQ(reason_of({.opaque = true}), "ambient occlusion is on");
}

TEST(frame_graph, copies_what_is_opaque_only_for_rough_surfaces_that_let_light_through) {
  const FrameNeeds frosted{.opaque = true, .blended = true, .frosted = true, .occlusion = false, .ground = true};
  EXPECT_THAT(passes(frosted), ElementsAre(Pass::opaque, Pass::ground, Pass::behind, Pass::transparent, Pass::tonemap));
  EXPECT_TRUE(FrameGraph(frosted).behind_image);
  const auto reason_of = [](const FrameNeeds& needs) {
    EXPECT_EQ(FrameGraph(needs).behind_image, FrameGraph(needs).has(Pass::behind));
    return describe_passes(needs, {})[static_cast<std::size_t>(Pass::behind)].reason;
  };
  EXPECT_EQ(reason_of(frosted), "rough surfaces blur what is behind them, thick ones refract it");
  EXPECT_EQ(reason_of({.opaque = true, .blended = true}), "nothing rough or thick is in view that lets light through");
  EXPECT_EQ(reason_of({.blended = true, .frosted = true, .gooch = true}), "Gooch shading lets no light through");
  EXPECT_EQ(reason_of({.blended = true, .frosted = true, .show = Show::depth}), "the picture shows a buffer instead");
  EXPECT_FALSE(FrameGraph({.blended = true, .frosted = true, .gooch = true}).behind_image);
  EXPECT_FALSE(FrameGraph({.blended = true, .frosted = true, .show = Show::depth}).behind_image);
}

TEST(frame_graph, has_no_occlusion_without_opaque_surfaces) {
  EXPECT_THAT(passes({.opaque = false, .blended = true}), ElementsAre(Pass::opaque, Pass::transparent, Pass::tonemap));
}

TEST(frame_graph, P17_has_no_pass_for_ambient_visibility_that_comes_with_the_vertices) {
  const FrameNeeds needs{.opaque = true, .occlusion = false, .baked = true};
  EXPECT_THAT(passes(needs), ElementsAre(Pass::opaque, Pass::tonemap));
  EXPECT_TRUE(FrameGraph(needs).vertex_visibility);
  EXPECT_FALSE(FrameGraph(needs).normal_image || FrameGraph(needs).ao_image);
  for (const PassStage& stage : describe_passes(needs, {.opaque_draws = 1, .extent = {8, 8}, .ao_texels = 16}))
    if (stage.pass == Pass::normal_depth || stage.pass == Pass::ssao || stage.pass == Pass::blur_vertical) {
      EXPECT_FALSE(stage.runs);
      EXPECT_EQ(stage.count, 0u);
      EXPECT_EQ(stage.reason, "ambient visibility comes with the vertices, baked by rays");
    } else if (stage.pass == Pass::opaque) {
      EXPECT_EQ(stage.reason, "shades what is opaque or alpha-tested, with the ambient visibility of the vertices");
    }
  const FrameNeeds shown{.opaque = true, .occlusion = false, .baked = true, .show = Show::ao};
  EXPECT_THAT(passes(shown), ElementsAre(Pass::normal_depth, Pass::show));
  EXPECT_TRUE(FrameGraph(shown).normal_image && FrameGraph(shown).vertex_visibility);
  EXPECT_FALSE(FrameGraph({.opaque = true, .ambient = false, .occlusion = false, .baked = true}).vertex_visibility);
  EXPECT_FALSE(FrameGraph({.opaque = true, .baked = true, .show = Show::normals}).vertex_visibility);
  EXPECT_TRUE(FrameGraph({.blended = true, .occlusion = false, .baked = true}).vertex_visibility);
}

TEST(frame_graph, sums_what_blends_in_any_order_behind_what_is_sorted) {
  const FrameGraph both({.opaque = true, .blended = true, .weighted = true, .ambient = false});
  EXPECT_THAT(std::vector<Pass>(both.begin(), both.end()),
              ElementsAre(Pass::opaque, Pass::transparent, Pass::weighted, Pass::tonemap));
  EXPECT_TRUE(both.weighted_images);
  EXPECT_FALSE(FrameGraph({.opaque = true, .blended = true}).weighted_images);
  const FrameNeeds alone{.weighted = true, .occlusion = false, .baked = true, .auto_exposure = true};
  EXPECT_TRUE(FrameGraph(alone).has(Pass::exposure));
  EXPECT_TRUE(FrameGraph(alone).vertex_visibility);
  EXPECT_TRUE(FrameGraph({.weighted = true, .shadows = true}).has(Pass::shadow));
  EXPECT_FALSE(FrameGraph({.weighted = true, .show = Show::normals}).weighted_images) << "buffers show what is opaque";
}

TEST(frame_graph, has_no_transparent_pass_without_blended_materials) {
  EXPECT_FALSE(FrameGraph({.opaque = true}).has(Pass::transparent));
  EXPECT_TRUE(FrameGraph({.opaque = true, .blended = true}).has(Pass::transparent));
}

TEST(frame_graph, has_an_image_for_unlit_colors_only_where_some_are_in_the_picture) {
  EXPECT_FALSE(FrameGraph({.opaque = true}).unlit_image);
  EXPECT_TRUE(FrameGraph({.opaque = true, .unlit = true}).unlit_image);
  EXPECT_FALSE(FrameGraph({.opaque = true, .unlit = true, .show = Show::normals}).unlit_image);
  EXPECT_TRUE(FrameGraph({.opaque = true, .auto_exposure = true, .ground = true, .grid = true}).unlit_image)
      << "for lines that no exposure changes";
  EXPECT_FALSE(FrameGraph({.opaque = true, .ground = true, .grid = true}).unlit_image) << "it is known beforehand";
  EXPECT_FALSE(FrameGraph({.opaque = true, .auto_exposure = true, .ground = true}).unlit_image);
}

TEST(frame_graph, looks_for_the_exposure_only_where_it_is_automatic_and_something_is_in_view) {
  EXPECT_THAT(passes({.opaque = true, .occlusion = false, .auto_exposure = true}),
              ElementsAre(Pass::opaque, Pass::exposure, Pass::tonemap));
  EXPECT_FALSE(FrameGraph({.auto_exposure = true}).exposure_image);
  EXPECT_FALSE(FrameGraph({.opaque = true}).exposure_image);
  EXPECT_FALSE(FrameGraph({.opaque = true, .auto_exposure = true, .show = Show::depth}).exposure_image);
}

TEST(frame_graph, draws_the_ground_over_what_is_opaque_and_before_it_for_occlusion) {
  EXPECT_THAT(passes({.opaque = true, .blended = true, .occlusion = false, .ground = true}),
              ElementsAre(Pass::opaque, Pass::ground, Pass::transparent, Pass::tonemap));
  EXPECT_FALSE(FrameGraph({.opaque = true, .occlusion = false, .ground = true}).ground_occluded);
  EXPECT_TRUE(FrameGraph({.opaque = true, .ground = true}).ground_occluded);
  EXPECT_TRUE(FrameGraph({.opaque = true, .ground = true, .show = Show::ao}).ground_occluded);
  EXPECT_FALSE(FrameGraph({.opaque = true, .ground = true, .show = Show::normals}).ground_occluded);
  EXPECT_TRUE(FrameGraph({.shadows = true, .ground = true}).has(Pass::shadow)) << "the caster may be out of view";
}

TEST(frame_graph, draws_depth_alone_beforehand_for_lines_that_surfaces_may_hide) {
  const FrameNeeds needs{.opaque = true, .overlay = true, .lines = true, .occlusion = false, .baked = true};
  EXPECT_THAT(passes(needs), ElementsAre(Pass::normal_depth, Pass::opaque, Pass::tonemap, Pass::overlay));
  EXPECT_TRUE(FrameGraph(needs).depth_image);
  EXPECT_FALSE(FrameGraph(needs).normal_image);
  EXPECT_EQ(describe_passes(needs, {})[static_cast<std::size_t>(Pass::normal_depth)].reason,
            "depth only: lines are fainter behind surfaces");
  EXPECT_FALSE(FrameGraph({.opaque = true, .overlay = true, .occlusion = false}).has(Pass::normal_depth)) << "a panel";
  EXPECT_FALSE(FrameGraph({.blended = true, .overlay = true, .lines = true}).has(Pass::normal_depth));
}

TEST(frame_graph, leaves_the_blur_and_its_image_out_when_it_is_off) {
  const FrameGraph graph({.opaque = true, .blur = false});
  EXPECT_TRUE(graph.has(Pass::ssao) && graph.ao_image);
  EXPECT_FALSE(graph.has(Pass::blur_horizontal) || graph.has(Pass::blur_vertical) || graph.half_blurred_ao);
}

TEST(frame_graph, shows_a_buffer_without_shading_anything) {
  EXPECT_THAT(passes({.opaque = true, .blended = true, .show = Show::normals}),
              ElementsAre(Pass::normal_depth, Pass::show));
  EXPECT_THAT(passes({.opaque = true, .show = Show::depth}), ElementsAre(Pass::normal_depth, Pass::show));
  EXPECT_THAT(passes({.opaque = true, .ambient = false, .show = Show::ao}),
              ElementsAre(Pass::normal_depth, Pass::ssao, Pass::blur_horizontal, Pass::blur_vertical, Pass::show));
  EXPECT_FALSE(FrameGraph({.opaque = true, .show = Show::depth}).color_image);
}

TEST(frame_graph, P17_depth_alone_is_made_when_nobody_reads_normals) {
  EXPECT_FALSE(FrameGraph({.opaque = true, .show = Show::depth}).normal_image);
  EXPECT_FALSE(FrameGraph({.opaque = true, .occlusion = false, .show = Show::ao}).normal_image);
  EXPECT_TRUE(FrameGraph({.opaque = true, .show = Show::ao}).normal_image);
  EXPECT_TRUE(FrameGraph({.opaque = true, .show = Show::normals}).normal_image);
}

TEST(frame_graph, P17_occlusion_of_strength_0_is_none) {
  AmbientOcclusion ao;
  EXPECT_TRUE(ao.has_effect());
  ao.power = 0.0f;
  EXPECT_FALSE(ao.has_effect());
  ao = {.radius_m = 0.0f};
  EXPECT_FALSE(ao.has_effect());
}

TEST(frame_graph, gooch_shading_draws_outlines_from_normals_and_depth_on_what_is_opaque) {
  const FrameNeeds needs{.opaque = true, .blended = true, .unlit = true, .gooch = true, .ambient = false};
  EXPECT_THAT(passes(needs),
              ElementsAre(Pass::normal_depth, Pass::opaque, Pass::outline, Pass::transparent, Pass::tonemap));
  const FrameGraph graph(needs);
  EXPECT_TRUE(graph.normal_image && graph.depth_image && graph.unlit_image);
  EXPECT_FALSE(graph.ao_image || graph.shadow_maps > 0 || graph.exposure_image);
  EXPECT_FALSE(FrameGraph({.blended = true, .gooch = true, .ambient = false}).has(Pass::outline));
  EXPECT_FALSE(FrameGraph({.opaque = true, .gooch = true, .show = Show::depth}).has(Pass::outline));
}

TEST(frame_graph, names_every_pass) {
  EXPECT_EQ(name_of(Pass::normal_depth), "normal_depth");
  EXPECT_EQ(name_of(Pass::overlay), "overlay");
}

}  // namespace
}  // namespace sinew::viewer
