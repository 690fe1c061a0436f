// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/geometry_player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "runtime/base/same_bits.h"
#include "runtime/geometry_cache/scene_of_cache.h"
#include "runtime/plan/run_plan.h"
#include "tests/geometry_cache/disk.h"
#include "tests/geometry_cache/takes.h"

namespace sinew::test {
namespace {

/// A flag, played from its own cache.
class geometry_player : public testing::Test {
 protected:
  geometry_player() : made_(*scene_of(cache_, mapped_)), player_(cache_, mapped_, made_.scene, made_.bindings) {
    needs_.in.cached_instances = player_.instances();
    plan_ = compile_plan(lend(made_.scene), needs_);
  }

  const FrameResult& play(FrameBuffer& frame, double time_s, float weight = 1.0f) {
    const std::vector<GeometryInput> geometry(needs_.in.cached_instances.size(), player_.at(time_s, weight));
    FrameInput input;
    input.geometry = geometry;
    EXPECT_EQ(run_plan(plan_, input, frame), ErrorCode::ok);
    return frame.result();
  }

  std::vector<std::byte> file_ = *encode_geometry_cache(flag_take(20), {.segment_frames = 8});
  GeometryCache cache_ = *GeometryCache::open(file_);
  MappedFrames mapped_{cache_, file_};
  CacheScene made_;
  GeometryPlayer player_;
  Needs needs_;
  Plan plan_;
};

TEST_F(geometry_player, the_scene_of_a_cache_passes_the_checks_and_has_its_names) {
  EXPECT_EQ(check(made_.scene), ErrorCode::ok);
  ASSERT_EQ(made_.scene.instances.size(), 1u);
  EXPECT_EQ(made_.scene.skeleton.names[0], "mesh");
  EXPECT_EQ(made_.scene.meshes[0].name, "mesh");
  EXPECT_EQ(made_.scene.materials[0].name, "mesh");
  EXPECT_EQ(made_.scene.meshes[0].primitives[0].indices, cache_.meshes()[0].triangles);
  EXPECT_EQ(bind_by_name(cache_, made_.scene).bound.size(), 1u);
  EXPECT_TRUE(bind_by_name(cache_, made_.scene).unbound.empty());
}

TEST_F(geometry_player, frames_show_the_bits_of_the_decoder_in_any_order) {
  FrameBuffer frame(plan_);
  GeometryDecoder decoder(cache_);
  std::vector<glm::vec3> expected(cache_.meshes()[0].vertex_count);
  FixedRandom random(3);
  for (int k = 0; k < 60; ++k) {
    const double time_s = cache_.duration_s() * random.in(-0.1, 1.1);
    ASSERT_EQ(decoder.decode_time(time_s, mapped_), GeometryStatus::ok);
    ASSERT_EQ(decoder.write_vertices(0, expected), GeometryStatus::ok);
    const FrameResult& shown = play(frame, time_s);
    ASSERT_TRUE(same_bits<glm::vec3>(shown.primitives[0].positions, expected)) << time_s;
    const Aabb box = player_.bounds(0, time_s);
    for (const glm::vec3& x : expected)
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_LE(box.lower[axis], x[axis]);
        ASSERT_GE(box.upper[axis], x[axis]);
      }
  }
}

TEST_F(geometry_player, playing_forward_decodes_each_frame_once) {
  FrameBuffer frame(plan_);
  std::uint64_t decoded = 0;
  for (std::uint32_t f = 0; f < 20; ++f) {
    decoded += play(frame, f * cache_.frame_s()).work.cache_frames_decoded;
    EXPECT_EQ(decoded, f + 1u);
    EXPECT_EQ(play(frame, f * cache_.frame_s()).work, WorkCounters{});
  }
}

/// Same, with frames that come through a window.
class geometry_player_window : public geometry_player {
 protected:
  const FrameResult& play_from(GeometryPlayer& player, FrameBuffer& frame, double time_s,
                               std::span<const std::uint8_t> out_of_view = {}) {
    const GeometryInput geometry = player.at(time_s);
    FrameInput input;
    input.geometry = {&geometry, 1};
    input.out_of_view = out_of_view;
    EXPECT_EQ(run_plan(plan_, input, frame), ErrorCode::ok);
    return frame.result();
  }
  void expect_bits(const FrameResult& shown, std::uint32_t frame) {
    GeometryDecoder decoder(cache_);
    ASSERT_EQ(decoder.decode(frame, mapped_), GeometryStatus::ok);
    std::vector<glm::vec3> expected(cache_.meshes()[0].vertex_count);
    ASSERT_EQ(decoder.write_vertices(0, expected), GeometryStatus::ok);
    EXPECT_TRUE(same_bits<glm::vec3>(shown.primitives[0].positions, expected)) << "frame " << frame;
  }
  double time_of(std::uint32_t frame) const { return frame * cache_.frame_s(); }

  Disk disk_{file_};
};

TEST_F(geometry_player_window, a_loop_with_a_slow_reader_does_not_stall_at_its_seam) {
  disk_.at_once = false;
  FrameWindow window(cache_, disk_.reader(), 4);
  GeometryPlayer player(cache_, window, made_.scene, made_.bindings);
  FrameBuffer frame(plan_);
  window.prefetch(0);
  disk_.deliver(100);
  for (std::uint32_t shown = 0; shown < 50; ++shown) {  // a read takes two frames
    EXPECT_FALSE(play_from(player, frame, time_of(shown % 20)).instances[0].late) << shown;
    expect_bits(frame.result(), shown % 20);
    if (shown % 2 == 1) disk_.deliver(100);
  }
  EXPECT_LE(disk_.reads, 50u + 3u) << "each frame is read once";
  disk_.deliver(100);
}

TEST_F(geometry_player_window, slow_motion_reads_each_frame_once) {
  FrameWindow window(cache_, disk_.reader(), 4);
  GeometryPlayer player(cache_, window, made_.scene, made_.bindings);
  FrameBuffer frame(plan_);
  for (int step = 0; step <= 76; ++step) play_from(player, frame, 0.25 * step * cache_.frame_s());
  EXPECT_EQ(player.decoder().frames_decoded(), 20u);
  EXPECT_LE(disk_.reads, 20u + 4u) << "each frame, and the window from the first one on";
}

TEST_F(geometry_player_window, what_is_out_of_view_reads_nothing) {
  FrameWindow window(cache_, disk_.reader(), 4);
  GeometryPlayer player(cache_, window, made_.scene, made_.bindings);
  FrameBuffer frame(plan_);
  const std::uint8_t unseen[] = {1};
  for (std::uint32_t f = 0; f < 10; ++f) {
    play_from(player, frame, time_of(f), unseen);
    EXPECT_FALSE(player.bounds(0, time_of(f)).empty());
  }
  EXPECT_EQ(window.bytes_requested(), 0u);
  EXPECT_EQ(player.decoder().frames_decoded(), 0u);
  expect_bits(play_from(player, frame, time_of(10)), 10);
  const std::uint64_t asked = window.bytes_requested();
  play_from(player, frame, time_of(10));
  EXPECT_EQ(window.bytes_requested(), asked) << "paused";
}

TEST_F(geometry_player_window, a_reader_that_is_late_shows_the_newest_frame_and_says_so) {
  disk_.at_once = false;
  FrameWindow window(cache_, disk_.reader(), 6);
  GeometryPlayer player(cache_, window, made_.scene, made_.bindings);
  FrameBuffer frame(plan_);
  EXPECT_TRUE(play_from(player, frame, 0.0).instances[0].late);
  EXPECT_FALSE(frame.result().instances[0].from_cache);
  disk_.deliver(3);
  EXPECT_TRUE(play_from(player, frame, time_of(5)).instances[0].late);
  expect_bits(frame.result(), 2);
  const std::uint64_t since = frame.result().primitives[0].since_frame;
  EXPECT_EQ(play_from(player, frame, time_of(5)).primitives[0].since_frame, since) << "nothing new came";
  disk_.deliver(100);
  EXPECT_FALSE(play_from(player, frame, time_of(5)).instances[0].late);
  expect_bits(frame.result(), 5);
  disk_.deliver(100);
}

TEST_F(geometry_player_window, a_damaged_frame_leaves_the_pose_and_the_next_segment_plays) {
  disk_.file[cache_.frames()[9].offset + 20] ^= std::byte(4);
  FrameWindow window(cache_, disk_.reader(), 4);
  GeometryPlayer player(cache_, window, made_.scene, made_.bindings);
  FrameBuffer frame(plan_);
  EXPECT_FALSE(play_from(player, frame, time_of(8)).instances[0].late);
  EXPECT_TRUE(play_from(player, frame, time_of(9)).instances[0].late);
  EXPECT_FALSE(frame.result().instances[0].from_cache);
  EXPECT_EQ(player.status(), GeometryStatus::damaged);
  EXPECT_TRUE(play_from(player, frame, time_of(12)).instances[0].late) << "it follows from the damaged one";
  EXPECT_FALSE(play_from(player, frame, time_of(16)).instances[0].late);
  expect_bits(frame.result(), 16);
}

/// A strip of four triangles with stored normals and colours.
GeometryTake strip_take() {
  GeometryTake take = take_of({}, {0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5});
  TakeMesh& mesh = take.meshes[0];
  mesh.name = "strip";
  mesh.vertex_count = 6;
  mesh.streams.push_back({GeometryKind::normals, {}, 1e-3});
  mesh.streams.push_back({GeometryKind::colors, {}, 1e-3});
  for (int f = 0; f < 3; ++f)
    for (auto& stream : mesh.streams) {
      auto& values = stream.frames.emplace_back();
      for (int v = 0; v < 6; ++v) {
        const auto number = static_cast<float>(v), frame = static_cast<float>(f), turn = 0.4f * (number + frame);
        switch (stream.kind) {
          case GeometryKind::positions: values.emplace_back(v / 2, v % 2, 0.1f * frame * number); break;
          case GeometryKind::normals: values.emplace_back(std::sin(turn), 0.0f, std::cos(turn)); break;
          case GeometryKind::colors: values.emplace_back(0.125f * number, 0.5f, 1.0f); break;
        }
      }
    }
  return take;
}

TEST(geometry_player_streams, normals_of_the_cache_are_unit_and_colours_are_those_of_the_first_frame) {
  const GeometryTake take = strip_take();
  const std::vector<std::byte> file = *encode_geometry_cache(take);
  const GeometryCache cache = *GeometryCache::open(file);
  MappedFrames frames{cache, file};
  const CacheScene made = *scene_of(cache, frames);
  EXPECT_EQ(check(made.scene), ErrorCode::ok);
  const Primitive& primitive = made.scene.meshes[0].primitives[0];
  ASSERT_EQ(primitive.colors.size(), 6u);
  EXPECT_NEAR(primitive.colors[3].x, 0.375f, 1e-3f);
  GeometryPlayer player(cache, frames, made.scene, made.bindings);
  const Plan plan = compile_plan(lend(made.scene), {.in = {.cached_instances = player.instances()}});
  FrameBuffer frame(plan);
  const GeometryInput geometry = player.at(0.5 * cache.frame_s());
  FrameInput input;
  input.geometry = {&geometry, 1};
  ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
  EXPECT_EQ(frame.result().work.smooth_triangles, 0u);
  for (std::size_t v = 0; v < 6; ++v) {
    const glm::vec3 expected =
        glm::normalize(take.meshes[0].streams[1].frames[0][v] + take.meshes[0].streams[1].frames[1][v]);
    EXPECT_NEAR(glm::length(frame.result().primitives[0].normals[v]), 1.0f, 1e-6f);
    EXPECT_LT(glm::distance(frame.result().primitives[0].normals[v], expected), 3e-3f);
  }
}

/// Three separate meshes. The last has its own normal for each vertex, one of them zero, and a single colour.
GeometryTake three_meshes() {
  GeometryTake take = noise_take(5, 3, 1e-3);
  take.meshes.push_back(noise_take(70, 3, 1e-3).meshes[0]);
  take.meshes.push_back(noise_take(40, 3, 1e-3).meshes[0]);
  for (std::size_t m = 0; m < 3; ++m) {
    take.meshes[m].name = "mesh" + std::to_string(m);
    for (auto& frame : take.meshes[m].streams[0].frames)
      for (glm::vec3& p : frame) p.x += 100.0f * static_cast<float>(m);
  }
  TakeStream normals{GeometryKind::normals, {}, 1e-3}, colors{GeometryKind::colors, {}, 1e-2};
  FixedRandom random(5);
  for (int f = 0; f < 3; ++f) {
    auto& frame = normals.frames.emplace_back();
    for (int v = 0; v < 40; ++v) frame.push_back(v == 7 ? glm::vec3(0) : random.direction());
    colors.frames.emplace_back(40, glm::vec3(0.25f, 0.5f, 1.0f));
  }
  take.meshes[2].streams.push_back(normals);
  take.meshes[2].streams.push_back(colors);
  return take;
}

TEST(geometry_player_streams, each_mesh_shows_its_own_streams_and_box) {
  const GeometryTake take = three_meshes();
  const auto file = *encode_geometry_cache(take);
  const auto cache = GeometryCache::open(file);
  MappedFrames mapped{*cache, file};
  const auto made = scene_of(*cache, mapped);
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(made->scene.meshes[2].primitives[0].normals[7], glm::vec3(0, 1, 0));
  const Skeleton& skeleton = made->scene.skeleton;
  EXPECT_EQ(skeleton.parents, std::vector<std::uint32_t>(3, kNone)) << "a root joint of its own";
  EXPECT_EQ(skeleton.fixed_matrix_of, std::vector<std::uint32_t>(3, kNone));
  EXPECT_EQ(skeleton.node_of_joint, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(skeleton.joint_of_node, (std::vector<std::uint32_t>{0, 1, 2}));
  for (std::uint32_t m = 0; m < 3; ++m) {
    const std::string name = "mesh" + std::to_string(m);
    EXPECT_EQ(skeleton.names[m], name);
    EXPECT_EQ(made->scene.meshes[m].name, name);
    const Material& material = made->scene.materials.at(made->scene.meshes[m].primitives[0].material);
    EXPECT_EQ(material.name, name);
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_TRUE(material.double_sided);
    EXPECT_EQ(made->scene.instances[m].joint, m);
    EXPECT_EQ(made->scene.instances[m].mesh, m);
  }
  GeometryPlayer player(*cache, mapped, made->scene, made->bindings);
  EXPECT_EQ(player.instances(), (std::vector<std::uint32_t>{0, 1, 2}));
  VertexSource source = player.source();
  for (std::uint32_t m = 0; m < 3; ++m) {
    const double time_s = cache->start_s() + cache->frame_s();
    const ShownVertices shown = source.show(source.context, m, time_s);
    ASSERT_TRUE(shown.is_there);
    EXPECT_GT(shown.bounds.lower.x, 100.0f * static_cast<float>(m) - 4.0f);
    EXPECT_LT(shown.bounds.upper.x, 100.0f * static_cast<float>(m) + 4.0f);
    EXPECT_EQ(player.bounds(m, time_s).lower, cache->bounds(1, m).lower);
    std::vector<glm::vec3> positions(take.meshes[m].vertex_count), normals = positions;
    EXPECT_EQ(source.write(source.context, m, 0, positions, normals), m == 2);
    for (std::size_t v = 0; v < positions.size(); ++v)
      EXPECT_LT(glm::length(positions[v] - take.meshes[m].streams[0].frames[1][v]), 1.1e-3f) << m << ' ' << v;
    for (std::size_t v = 0; v < normals.size() && m == 2; ++v) {
      const glm::vec3 expected = v == 7 ? glm::vec3(0, 1, 0) : take.meshes[2].streams[1].frames[1][v];
      EXPECT_LT(glm::length(normals[v] - expected), 2e-3f) << v;
    }
  }
  EXPECT_FALSE(source.has(source.context, 3));
}

TEST(geometry_player_streams, contents_differ_by_file_and_by_what_plays_where) {
  const GeometryTake take = three_meshes();
  GeometryTake other = take;
  other.meshes[0].streams[0].frames[2][3].z += 0.5f;
  const auto file = *encode_geometry_cache(take), changed = *encode_geometry_cache(other);
  const auto cache = GeometryCache::open(file), changed_cache = GeometryCache::open(changed);
  MappedFrames mapped{*cache, file}, changed_mapped{*changed_cache, changed};
  const auto made = scene_of(*cache, mapped);
  const auto content = [&](const GeometryCache& of, FrameSource frames, std::span<const GeometryBinding> bindings) {
    return GeometryPlayer(of, frames, made->scene, bindings).source().content;
  };
  const std::span<const GeometryBinding> all = made->bindings;
  EXPECT_EQ(content(*cache, mapped, all), content(*cache, mapped, all));
  EXPECT_NE(content(*cache, mapped, all), content(*changed_cache, changed_mapped, all));
  EXPECT_NE(content(*cache, mapped, all), content(*cache, mapped, all.first(2)));
  EXPECT_NE(content(*cache, mapped, all.first(1)), content(*cache, mapped, all.subspan(1, 1)));
}

TEST(geometry_player_streams, contents_differ_where_primitives_take_each_others_meshes) {
  GeometryTake take = noise_take(5, 3, 1e-3);
  take.meshes.push_back(take.meshes[0]);
  const auto file = *encode_geometry_cache(take);
  const auto cache = GeometryCache::open(file);
  MappedFrames mapped{*cache, file};
  auto made = scene_of(*cache, mapped);
  std::vector<Primitive>& primitives = made->scene.meshes[0].primitives;
  primitives.push_back(primitives[0]);
  const auto content = [&](const std::array<GeometryBinding, 2>& bindings) {
    return GeometryPlayer(*cache, mapped, made->scene, bindings).source().content;
  };
  EXPECT_NE(content({{{0, 0, 0}, {0, 1, 1}}}), content({{{0, 1, 0}, {0, 0, 1}}}));
}

TEST(geometry_player_streams, a_scene_has_the_first_frame_of_each_mesh) {
  GeometryTake take = strip_take();
  take.meshes.push_back(noise_take(5, 3, 1e-3).meshes[0]);
  const std::vector<std::byte> file = *encode_geometry_cache(take);
  const GeometryCache cache = *GeometryCache::open(file);
  MappedFrames frames{cache, file};
  const CacheScene made = *scene_of(cache, frames);
  for (std::size_t m = 0; m < 2; ++m)
    for (std::size_t v = 0; v < take.meshes[m].vertex_count; ++v)
      EXPECT_LT(glm::distance(made.scene.meshes[m].primitives[0].positions[v], take.meshes[m].streams[0].frames[0][v]),
                2e-3f)
          << m;
}

/// A strip in which pairs of vertices share a position but not a normal.
TEST(geometry_player_streams, a_mesh_may_have_more_normals_than_places) {
  GeometryTake take = strip_take();
  TakeMesh& mesh = take.meshes[0];
  for (auto& positions : mesh.streams[0].frames)
    for (std::size_t v = 1; v < 6; v += 2) positions[v] = positions[v - 1];
  const std::vector<std::byte> file = *encode_geometry_cache(take);
  const GeometryCache cache = *GeometryCache::open(file);
  ASSERT_LT(cache.meshes()[0].streams[0].point_count, cache.meshes()[0].streams[1].point_count);
  MappedFrames frames{cache, file};
  const CacheScene made = *scene_of(cache, frames);
  GeometryPlayer player(cache, frames, made.scene, made.bindings);
  const VertexSource source = player.source();
  std::vector<glm::vec3> positions(6), normals(6);
  ASSERT_TRUE(source.show(source.context, 0, 0.0).is_there);
  ASSERT_TRUE(source.write(source.context, 0, 0, positions, normals));
  for (std::size_t v = 0; v < 6; ++v) {
    EXPECT_LT(glm::distance(positions[v], mesh.streams[0].frames[0][v]), 1e-3f);
    EXPECT_LT(glm::distance(normals[v], mesh.streams[1].frames[0][v]), 3e-3f);
  }
}

TEST(geometry_player_streams, a_mesh_without_normals_has_smooth_ones_over_its_points) {
  // Two squares that meet at a right angle. Vertices of the seam are doubled, and each pair is one point.
  const std::vector<glm::vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1},
                                          {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<std::uint32_t> triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 6, 5, 7};
  const auto file = *encode_geometry_cache(take_of({corners, corners}, triangles));
  const auto cache = GeometryCache::open(file);
  MappedFrames mapped{*cache, file};
  const auto made = scene_of(*cache, mapped);
  ASSERT_TRUE(made.has_value());
  const std::vector<glm::vec3>& normals = made->scene.meshes[0].primitives[0].normals;
  ASSERT_EQ(normals.size(), 8u);
  EXPECT_LT(glm::length(normals[3] - glm::vec3(0, 1, 0)), 1e-3f);
  EXPECT_LT(glm::length(normals[7] - glm::vec3(0, 0, 1)), 1e-3f);
  EXPECT_EQ(normals[0], normals[4]);
  EXPECT_EQ(normals[1], normals[5]);
  EXPECT_GT(normals[0].y, 0.3f);
  EXPECT_GT(normals[0].z, 0.3f);
}

TEST(geometry_player_streams, a_mesh_without_triangles_is_shown_as_points) {
  const std::vector<std::byte> file = *encode_geometry_cache(strip_take(), {.keep_triangles = false});
  const GeometryCache cache = *GeometryCache::open(file);
  MappedFrames frames{cache, file};
  const CacheScene made = *scene_of(cache, frames);
  EXPECT_EQ(check(made.scene), ErrorCode::ok);
  EXPECT_EQ(made.scene.meshes[0].primitives[0].topology, Topology::points);
  GeometryPlayer player(cache, frames, made.scene, made.bindings);
  EXPECT_EQ(player.instances().size(), 1u);
  FrameSource nothing{[](void*, std::uint32_t) noexcept { return std::span<const std::byte>(); }, nullptr};
  EXPECT_EQ(scene_of(cache, nothing).error(), GeometryStatus::not_loaded);
}

}  // namespace
}  // namespace sinew::test
