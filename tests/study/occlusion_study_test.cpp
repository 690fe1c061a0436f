// SPDX-License-Identifier: MIT
// Compares rays with the plain reference that tests every triangle, and checks what the study must find on every
// device.
#include "tests/study/occlusion_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/reference/ray_cast.h"
#include "tests/support/fixed_random.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/passes/frame_renderer.h"
#include "tests/study/exhaustive_access.h"

namespace sinew::viewer {
namespace {

std::vector<reference::RayTriangle> triangles_of(const BuiltScene& built) {
  std::vector<reference::RayTriangle> triangles;
  const FrameResult frame = built.frame();
  for (std::size_t i = 0; i < frame.instances.size(); ++i)
    for (const Primitive& primitive : built.scene.meshes[built.scene.instances[i].mesh].primitives)
      for (std::size_t k = 0; k < primitive.indices.size(); k += 3) {
        reference::RayTriangle& triangle = triangles.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
          triangle.corners[c] = glm::dvec3(
              transform_point(frame.instances[i].world_from_mesh, primitive.positions[primitive.indices[k + c]]));
          triangle.normals[c] = glm::dvec3(primitive.normals[primitive.indices[k + c]]);  // only moved, not turned
        }
      }
  return triangles;
}

TEST(ray_caster, N34_meets_what_the_reference_meets_and_finds_as_much_open) {
  const BuiltScene built = box_and_sphere_on_floor();
  const RayCaster rays(built.scene, built.frame());
  const auto triangles = triangles_of(built);
  test::FixedRandom random(1);
  int met = 0, occluded = 0;
  for (int i = 0; i < 400; ++i) {
    const glm::dvec3 from = 4.0 * random.direction<double>() + glm::dvec3(0, 1, 0),
                     direction = glm::normalize(random.vec3<double>() - from);
    const auto expected = reference::cast(triangles, from, direction);
    const auto seen = rays.seen(from, direction);
    ASSERT_EQ(seen.has_value(), expected.has_value()) << i;
    if (!seen) continue;
    ++met;
    EXPECT_LT(glm::length(seen->point - (from + expected->t * direction)), 1e-5);
    EXPECT_LT(glm::length(seen->normal - expected->normal), 1e-3);
    const double open = reference::open_share(
        triangles, reference::leave_surface(seen->point, seen->geometric, 0x1p-20), seen->normal, 0.6, 64);
    EXPECT_NEAR(rays.open_share(*seen, 0.6, 64), open, 2.5 / 64.0) << "two rays along an edge may differ";
    occluded += open < 0.9;
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(occluded, 20);
}

TEST(ray_caster, sees_back_faces_only_where_the_material_has_two_sides) {
  for (const bool double_sided : {false, true})
    for (const bool mirrored : {false, true}) {
      BuiltScene built;
      Material material = matte({1, 1, 1});
      material.double_sided = double_sided;
      Affine placed;
      if (mirrored) placed.row[0].x = -1.0f;
      built.add(square(1.0f), built.add_material(material), placed, mirrored);
      const RayCaster rays(built.scene, built.frame());
      const auto above = rays.seen({0.2, 1, 0.1}, {0, -1, 0}), below = rays.seen({0.2, -1, 0.1}, {0, 1, 0});
      ASSERT_TRUE(above) << mirrored;
      EXPECT_GT(above->normal.y, 0.99);
      EXPECT_EQ(below.has_value(), double_sided) << mirrored;
      EXPECT_LT(below ? below->normal.y : -1.0, -0.99) << "on the side that is looked at";
      EXPECT_EQ(rays.open_share(*above, 1.0, 64), 1.0) << "a plane does not darken itself";
    }
}

TEST(ray_caster, N36_rays_leave_their_own_triangle_a_kilometre_and_ten_from_the_origin) {
  for (const float out_m : {0.0f, 1024.0f, 16384.0f}) {
    BuiltScene built;
    Affine placed;
    placed.row[0].w = placed.row[2].w = out_m;
    placed.row[0].y = 0.3f;  // sheared and tilted: heights are no round numbers
    placed.row[1].x = 0.7f;
    built.add(square(2.0f), built.add_material(matte({1, 1, 1})), placed);
    const RayCaster rays(built.scene, built.frame());
    for (const double x : {-0.61, 0.13, 0.77}) {
      const glm::dvec3 above(out_m + x, 0.7 * x + 0.5, out_m + 0.2);
      const auto seen = rays.seen(above, {0, -1, 0});
      ASSERT_TRUE(seen) << out_m;
      EXPECT_EQ(rays.open_share(*seen, 5.0, 256), 1.0) << "a plane does not darken itself, " << out_m << " m out";
    }
  }
}

TEST(ray_caster, N36_no_ray_slips_through_edges_and_corners_and_slivers_stop_none) {
  BuiltScene built;
  Material both_sides = matte({1, 1, 1});
  both_sides.double_sided = true;
  Primitive ball = showcase::sphere({0, 0, 0}, 1.0f, 12, 6);
  ball.indices.insert(ball.indices.end(), {0, 0, 1, 2, 2, 2});  // without area
  built.add(ball, built.add_material(both_sides));
  const RayCaster rays(built.scene, built.frame());
  for (const glm::vec3& corner : ball.positions) {
    const auto seen = rays.seen({0, 0, 0}, glm::dvec3(corner));
    ASSERT_TRUE(seen) << corner.x << ' ' << corner.y << ' ' << corner.z;
    EXPECT_TRUE(std::isfinite(seen->normal.x) && glm::length(seen->point) > 0.5);
  }
  for (std::size_t i = 0; i + 2 < ball.indices.size(); ++i) {
    const glm::dvec3 a(ball.positions[ball.indices[i]]), b(ball.positions[ball.indices[i + 1]]);
    EXPECT_TRUE(glm::length(a + b) < 0.1 || rays.seen({0, 0, 0}, a + b)) << i;
  }
}

class occlusion_study : public DeviceTest {};

TEST_F(occlusion_study, N34_ambient_occlusion_is_nearer_to_rays_than_none_and_the_default_is_marked) {
  const BuiltScene built = box_and_sphere_on_floor();
  AmbientOcclusion settings;
  settings.radius_m = 0.6f;
  settings.surface_epsilon_m = 0.012f;
  settings.fade_start_m = 0.24f;
  settings.fade_end_m = 1.2f;
  const View view = look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05);
  const OcclusionStudy study =
      study_occlusion(*test_device(), built.scene, built.frame(), view, settings, {96, 64, 32, 2, false});
  EXPECT_EQ(study.device, test_device()->name());
  EXPECT_GT(study.pixels, 96u * 64u / 3);
  EXPECT_EQ(
      std::count_if(study.trials.begin(), study.trials.end(), [](const OcclusionTrial& t) { return t.is_default; }), 1);
  const auto error_of = [&](const std::string& name) {
    return std::find_if(study.trials.begin(), study.trials.end(), [&](const auto& t) { return t.name == name; })->error;
  };
  EXPECT_LT(error_of("2 slices of 12"), error_of("14 samples")) << "horizons are the default because they are nearer";
  for (const OcclusionTrial& trial : study.trials) {
    EXPECT_GT(trial.error, 0.0) << trial.name;
    EXPECT_LT(trial.error, study.error_without) << trial.name;
    EXPECT_EQ(trial.milliseconds.size(), test_device()->timestamp_bits() > 0 ? 2u : 0u) << trial.name;
    for (const double ms : trial.milliseconds) EXPECT_GT(ms, 0.0) << trial.name;
  }
}

TEST_F(occlusion_study,
       N34_rays_at_vertices_are_nearer_to_many_rays_the_more_there_are_and_know_no_more_than_the_mesh) {
  BuiltScene built;
  const std::uint32_t material = built.add_material(matte({1, 1, 1}));
  Primitive floor;  // 41 x 41 vertices, 0.1 m apart
  for (int z = 0; z <= 40; ++z)
    for (int x = 0; x <= 40; ++x) floor.positions.emplace_back(0.1f * (float(x) - 20), 0.0f, 0.1f * (float(z) - 20));
  floor.normals.assign(floor.positions.size(), {0, 1, 0});
  for (std::uint32_t z = 0; z < 40; ++z)
    for (std::uint32_t x = 0; x < 40; ++x) {
      const std::uint32_t v = 41 * z + x;
      floor.indices.insert(floor.indices.end(), {v, v + 41, v + 1, v + 1, v + 41, v + 42});
    }
  built.add(floor, material);
  built.add(showcase::sphere({0, 0.6f, 0}, 0.5f), material);
  AmbientOcclusion settings;
  settings.radius_m = 1.0f;
  const OcclusionStudy study =
      study_occlusion(*test_device(), built.scene, built.frame(), look_at({1.5, 3.2, 3.0}, {0, 0, 0}, 0.5, 0.05),
                      settings, {96, 64, 256, 0, true});
  ASSERT_EQ(study.at_vertices.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const VertexTrial& trial = study.at_vertices[i];
    EXPECT_EQ(trial.rays, 16u << (2 * i));
    EXPECT_GT(trial.vertex_error, 0.0);
    EXPECT_GT(trial.seconds, 0.0);
    if (i > 0) {
      EXPECT_LT(trial.vertex_error, 0.7 * study.at_vertices[i - 1].vertex_error);
    }
  }
  EXPECT_LT(study.at_vertices[3].vertex_error, 0.01);
  EXPECT_LT(study.at_vertices[3].error, 0.3 * study.error_without) << "the mesh is fine enough here";
}

TEST_F(occlusion_study, bakes_no_mesh_whose_many_rays_would_take_minutes) {
  BuiltScene built;
  Primitive dust = square(1.0f);
  dust.positions.resize(20001, glm::vec3(0.0f));
  dust.normals.resize(20001, {0, 1, 0});
  built.add(dust, built.add_material(matte({1, 1, 1})));
  const View view = look_at({0.0, 3.0, 0.1}, {0.0, 0.0, 0.0}, 0.9, 0.05);
  const OcclusionEffort effort{16, 12, 4, 0, false};
  const OcclusionStudy study = study_occlusion(*test_device(), built.scene, built.frame(), view, {}, effort);
  EXPECT_TRUE(study.at_vertices.empty());
  EXPECT_GT(study.pixels, 0u);
}

TEST_F(occlusion_study, rays_go_through_the_middles_of_the_pixels_that_the_device_fills) {
  const BuiltScene built = box_and_sphere_on_floor();
  constexpr int kWidth = 63, kHeight = 48;
  const View view = look_at({1.5, 3.2, 3.0}, {0.3, 0.4, 0.2}, 0.8, 0.05);
  const auto image = gpu_depth_and_normals(built, kWidth, kHeight, view, {});
  const RayCaster rays(built.scene, built.frame());
  const std::vector<double> access = true_access(rays, seen_pixels(rays, view, kWidth, kHeight), 0.5, 1);
  int differ = 0;
  for (std::size_t i = 0; i < access.size(); ++i) differ += (access[i] >= 0.0) != (image.distance[i] > 0.0);
  EXPECT_LE(differ, 3) << "but for roundings on an outline";
  EXPECT_GT(std::count_if(access.begin(), access.end(), [](double a) { return a < 0.0; }), 30)
      << "there is something beside the scene";
}

/// A floor that fills the picture, seen from above, with a wall on it or without.
BuiltScene floor_and(bool wall) {
  BuiltScene built;
  const std::uint32_t material = built.add_material(matte({1, 1, 1}));
  built.add(square(50.0f), material);
  Affine upright;  // the plane x = 0, facing +x
  upright.row[0] = {0, 1, 0, 0};
  upright.row[1] = {-1, 0, 0, 0};
  if (wall) built.add(square(50.0f), material, upright);
  return built;
}

TEST(exhaustive_access, is_what_is_open_beside_a_wall_and_thicker_bodies_hide_more) {
  const BuiltScene built = floor_and(true);
  const RayCaster rays(built.scene, built.frame());
  const View view = look_at({2.0, 8.0, 0.0}, {1.0, 0.0, 0.0}, 0.5, 0.05);
  constexpr int kWidth = 81, kHeight = 61, kReach = 16;  // a metre is 15 pixels
  const SeenPixels seen = seen_pixels(rays, view, kWidth, kHeight);
  const std::vector<double> access = exhaustive_access(seen, view, 1.0, 0.0),
                            thick = exhaustive_access(seen, view, 1.0, 0.2);
  int compared = 0;
  double off = 0.0, hidden_more = 0.0;
  for (int y = kReach; y < kHeight - kReach; ++y)
    for (int x = kReach; x < kWidth - kReach; ++x) {
      const auto i = static_cast<std::size_t>(y * kWidth + x);
      const glm::dvec3 p = seen.pixels[i]->point;
      if (std::abs(p.y) > 0.01 || p.x < 0.1 || p.x > 0.9) continue;
      // rays that meet the wall within a metre, weighted by the cosine
      const double open = 1.0 - (std::acos(p.x) - p.x * std::sqrt(1.0 - p.x * p.x)) / std::numbers::pi;
      off += std::abs(access[i] - open);
      hidden_more += access[i] - thick[i];
      EXPECT_LE(thick[i], access[i]);
      ++compared;
    }
  ASSERT_GT(compared, 100);
  EXPECT_LT(off / compared, 0.02);
  EXPECT_GT(hidden_more / compared, 0.01);
}

TEST(exhaustive_access, holes_between_surfaces_hide_nothing) {
  BuiltScene built;
  built.add(square(0.3f), built.add_material(matte({1, 1, 1})), translation({0.0f, -0.3f, 0.0f}));
  const RayCaster rays(built.scene, built.frame());
  const View view = look_at({0.4, 2.0, 0.7}, {0.0, -0.3, 0.0}, 0.6, 0.05);
  const SeenPixels seen = seen_pixels(rays, view, 32, 24);
  int surfaces = 0, holes = 0;
  const std::vector<double> access = exhaustive_access(seen, view, 1.0, 0.1);
  for (std::size_t i = 0; i < access.size(); ++i) {
    ++(seen.pixels[i] ? surfaces : holes);
    EXPECT_NEAR(access[i], 1.0, 1e-9) << i;
  }
  EXPECT_GT(surfaces, 50);
  EXPECT_GT(holes, 100);
}

/// Root mean square difference where a surface is seen.
double error_of(const std::vector<double>& access, const std::vector<double>& truth) {
  double squares = 0.0, pixels = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (truth[i] >= 0.0) {
      squares += (access[i] - truth[i]) * (access[i] - truth[i]);
      pixels += 1.0;
    }
  return std::sqrt(squares / pixels);
}

TEST_F(occlusion_study, horizons_are_compared_with_rays_only_where_a_surface_is_seen) {
  BuiltScene built;
  const std::uint32_t material = built.add_material(matte({1, 1, 1}));
  built.add(square(1.0f), material);
  built.add(showcase::sphere({0, 0.4f, 0}, 0.4f), material);
  const View view = look_at({1.0, 3.0, 2.0}, {0.0, 0.0, 0.0}, 0.9, 0.05);
  AmbientOcclusion settings;
  settings.radius_m = 0.6f;
  const OcclusionStudy study =
      study_occlusion(*test_device(), built.scene, built.frame(), view, settings, {32, 24, 64, 0, false});
  const RayCaster rays(built.scene, built.frame());
  const SeenPixels seen = seen_pixels(rays, view, 32, 24);
  const std::vector<double> truth = true_access(rays, seen, 0.6f, 64);
  EXPECT_GT(std::count(truth.begin(), truth.end(), -1.0), 100) << "much of the picture is empty";
  ASSERT_EQ(study.exhaustive.size(), 4u);
  for (const ExhaustiveTrial& trial : study.exhaustive) {
    EXPECT_NEAR(trial.error, error_of(exhaustive_access(seen, view, 0.6f, trial.thickness), truth), 1e-9);
    EXPECT_GT(trial.error, 0.001);
  }
}

TEST(occlusion_time, is_that_of_its_three_passes_and_of_no_other) {
  const auto times = std::to_array<PassTime>({{name_of(Pass::normal_depth), 1.0},
                                              {name_of(Pass::ssao), 2.0},
                                              {name_of(Pass::blur_horizontal), 4.0},
                                              {name_of(Pass::blur_vertical), 8.0},
                                              {name_of(Pass::opaque), 16.0}});
  EXPECT_EQ(occlusion_time_ms(times), 14.0);
  EXPECT_EQ(occlusion_time_ms(std::span(times).first(1)), 0.0) << "the picture has none";
  EXPECT_FALSE(occlusion_time_ms({}).has_value()) << "the device has no clock";
}

TEST(occlusion_effort, the_quick_one_is_a_quarter_of_the_picture_and_half_of_the_rays) {
  const OcclusionEffort whole, quick = OcclusionEffort::quick();
  EXPECT_EQ(2 * quick.width, whole.width);
  EXPECT_EQ(2 * quick.height, whole.height);
  EXPECT_EQ(2 * quick.rays, whole.rays);
  EXPECT_EQ(quick.repetitions % 2, 1) << "so that the median is one of them";
  EXPECT_LT(2 * quick.repetitions, whole.repetitions);
  EXPECT_TRUE(whole.every_way && whole.exhaustive);
  EXPECT_FALSE(quick.every_way || quick.exhaustive);
}

TEST_F(occlusion_study, without_occlusion_the_error_is_what_rays_find_and_an_open_floor_has_none) {
  const View view = look_at({2.0, 4.0, 0.1}, {1.0, 0.0, 0.0}, 0.5, 0.05);
  AmbientOcclusion settings;
  settings.radius_m = 2.0f;
  for (const bool wall : {false, true}) {
    const BuiltScene built = floor_and(wall);
    const OcclusionEffort effort{32, 24, 64, 0, false};
    const OcclusionStudy study = study_occlusion(*test_device(), built.scene, built.frame(), view, settings, effort);
    EXPECT_EQ(study.pixels, 32u * 24u) << "surfaces everywhere";
    const RayCaster rays(built.scene, built.frame());
    const SeenPixels seen = seen_pixels(rays, view, 32, 24);
    const std::vector<double> truth = true_access(rays, seen, 2.0, 64), open(truth.size(), 1.0);
    EXPECT_NEAR(study.error_without, error_of(open, truth), 1e-12);
    EXPECT_EQ(study.error_without > 0.05, wall);
    EXPECT_EQ(study.radius_m, 2.0);
    ASSERT_EQ(study.exhaustive.size(), 4u);
    EXPECT_LT(study.exhaustive[0].error, wall ? study.error_without : 1e-9) << "the picture shows part of the wall";
    for (std::size_t i = 0; i < 4; ++i) {
      const double thickness = 0.1 * static_cast<double>(i);
      EXPECT_NEAR(study.exhaustive[i].thickness, thickness, 1e-15);
      EXPECT_NEAR(study.exhaustive[i].error, error_of(exhaustive_access(seen, view, 2.0, thickness), truth), 1e-9);
    }
    for (const OcclusionTrial& trial : study.trials) {
      EXPECT_LT(trial.error, wall ? study.error_without : 0.01) << trial.name;
      EXPECT_TRUE(trial.milliseconds.empty()) << "no repetitions";
    }
  }
}

TEST_F(occlusion_study, every_way_is_a_list_of_different_shapes_with_the_default_among_them) {
  const BuiltScene built = floor_and(true);
  const View view = look_at({2.0, 4.0, 0.1}, {1.0, 0.0, 0.0}, 0.5, 0.05);
  const auto trials_of = [&](bool every_way) {
    const OcclusionEffort effort{16, 12, 1, 0, every_way, false};
    const OcclusionStudy study = study_occlusion(*test_device(), built.scene, built.frame(), view, {}, effort);
    EXPECT_TRUE(study.exhaustive.empty());
    return study.trials;
  };
  const auto all = trials_of(true), few = trials_of(false);
  EXPECT_EQ(all.size(), 16u);
  EXPECT_EQ(few.size(), 8u);
  for (const auto* trials : {&all, &few}) {
    std::size_t defaults = 0, full_size = 0, unblurred = 0;
    for (const OcclusionTrial& a : *trials) {
      defaults += a.is_default;
      full_size += a.shape.step == 1;
      unblurred += !a.blur;
      const bool points = a.method == OcclusionMethod::ssao;
      EXPECT_EQ(a.is_default, a.name == "2 slices of 12") << a.name;
      EXPECT_EQ(a.name.rfind(std::to_string(points ? a.shape.samples : a.shape.slices), 0), 0u) << a.name;
      EXPECT_EQ(a.name.find(" of " + std::to_string(2 * a.shape.steps)) != std::string::npos, !points) << a.name;
      EXPECT_EQ(a.name.find("full size") != std::string::npos, a.shape.step == 1) << a.name;
      EXPECT_EQ(a.name.find("no blur") != std::string::npos, !a.blur) << a.name;
      for (const OcclusionTrial& b : *trials)
        EXPECT_TRUE(&a == &b || !(a.shape == b.shape) || a.blur != b.blur || a.method != b.method)
            << a.name << ", " << b.name;
    }
    EXPECT_EQ(defaults, 1u);
    EXPECT_EQ(unblurred, 1u);
    EXPECT_EQ(full_size, 2u);
  }
  for (const OcclusionTrial& t : all) {
    EXPECT_EQ(t.shape.keep_edges, t.name != "2 slices of 12 plain blur") << t.name;
    EXPECT_EQ(t.shape.blur_reach != OcclusionShape{}.blur_reach, t.name == "2 slices of 12 wide blur") << t.name;
  }
}

}  // namespace
}  // namespace sinew::viewer
