// SPDX-License-Identifier: MIT
// Distances between evaluations, their colours, grids of pictures, and films.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "runtime/plan/run_plan.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "tests/support/file_text.h"
#include "viewer/app/compare/compare_views.h"
#include "viewer/app/compare/picture_grid.h"
#include "viewer/app/compare/vertex_distance.h"
#include "viewer/app/inspect/paint.h"
#include "viewer/app/pictures/film_writer.h"

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(compare_views, reads_two_to_four_and_quotes_what_is_wrong) {
  const auto views = parse_views("linear,dual-quaternion,center-of-rotation,compiled=0.1", 1);
  ASSERT_TRUE(views) << views.error();
  ASSERT_EQ(views->size(), 4u);
  EXPECT_EQ((*views)[1].skinning, Skinning::dual_quaternion);
  EXPECT_EQ((*views)[3].kind, CompareView::Kind::compiled);
  EXPECT_NEAR((*views)[3].budget_m, 1e-4, 1e-12);
  EXPECT_EQ(parse_views("files", 3)->back().file, 2u);
  for (const char* faulty : {"", "linear", "linear,", "linear,cubic", "linear,compiled", "linear,compiled=0",
                             "linear,compiled=x", "linear,linear,linear,linear,linear"})
    EXPECT_FALSE(parse_views(faulty, 1)) << faulty;
  EXPECT_FALSE(parse_views("files", 1));
  EXPECT_FALSE(parse_views("files", 5));
  EXPECT_THAT(parse_views("linear,cubic", 1).error(), HasSubstr("'cubic'"));
}

/// Two boxes; the second one moves 3 mm along x and 4 mm along z in a second.
Scene boxes() {
  showcase::SceneBuilder builder;
  const std::uint32_t red = builder.add_material("red", {1, 0, 0}, 0.5f, 1.0f);
  for (const char* name : {"still", "moving"}) {
    Mesh mesh{name, {showcase::box({0, 0, 0}, glm::vec3(0.1f))}, {}, {}};
    mesh.primitives[0].material = red;
    builder.add_instance(builder.add_joint(name, kNone, {}), builder.add_mesh(std::move(mesh)));
  }
  BoneAnimation bone;
  bone.joint = 1;
  bone.translation.times_s = {0.0f, 1.0f};
  bone.translation.values = {{0, 0, 0}, {0.003f, 0, 0.004f}};
  builder.add_animation({"move", 1.0, {bone}, {}});
  return builder.finish();
}

struct Posed {
  Posed(const Scene& scene, double time_s) : plan(compile_plan(lend(scene), {})), buffer(plan) {
    const ClipLayer layer{0, time_s};
    FrameInput input;
    input.layers = {&layer, 1};
    EXPECT_EQ(run_plan(plan, input, buffer), ErrorCode::ok);
  }
  Plan plan;
  FrameBuffer buffer;
};

TEST(vertex_distance, is_that_of_the_world_and_names_the_farthest_vertex) {
  const Scene scene = boxes();
  const Posed start(scene, 0.0), end(scene, 1.0);
  const VertexDistances none = vertex_distances(scene, start.buffer.result(), start.buffer.result());
  EXPECT_EQ(none.worst_m, 0.0);
  EXPECT_EQ(none.mean_m, 0.0);
  const VertexDistances moved = vertex_distances(scene, start.buffer.result(), end.buffer.result());
  EXPECT_NEAR(moved.worst_m, 0.005, 1e-9);
  EXPECT_NEAR(moved.mean_m, 0.0025, 1e-9);
  EXPECT_EQ(moved.worst_primitive, 1u);
  EXPECT_EQ(moved.vertices, 2 * scene.meshes[0].primitives[0].vertex_count());
}

TEST(painted_scene, shows_distances_on_white_surfaces) {
  const Scene scene = boxes();
  const Posed start(scene, 0.0), end(scene, 1.0);
  const VertexDistances moved = vertex_distances(scene, start.buffer.result(), end.buffer.result());
  const Scene painted = painted_scene(scene, end.buffer.result(), moved, 0.01);
  EXPECT_EQ(check(painted), ErrorCode::ok);
  EXPECT_EQ(painted.materials[0].base_color, glm::vec4(1.0f));
  EXPECT_EQ(painted.materials[0].metallic, 0.0f);
  EXPECT_EQ(painted.meshes[0].primitives[0].colors.at(0), glm::vec4(share_color(0.0), 1.0f));
  EXPECT_LT(glm::distance(painted.meshes[1].primitives[0].colors.at(0), glm::vec4(share_color(0.5), 1.0f)), 1e-5f);
  EXPECT_EQ(share_color(2.0), share_color(1.0));
  EXPECT_GT(share_color(1.0).r, share_color(1.0).b);
  EXPECT_LT(share_color(0.0).r, share_color(0.0).b);
}

Picture plain(std::uint8_t value) {
  Picture picture{2, 1, std::vector<std::uint8_t>(8, value)};
  return picture;
}

TEST(picture_grid, sets_pictures_in_rows_with_gaps) {
  const std::vector<Picture> pictures{plain(1), plain(2), plain(3)};
  const Picture grid = picture_grid(pictures, 2);
  ASSERT_EQ(grid.width, 2 + kGridGap + 2);
  ASSERT_EQ(grid.height, 1 + kGridGap + 1);
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return int{grid.rgba[4 * (y * grid.width + x)]}; };
  EXPECT_EQ(at(0, 0), 1);
  EXPECT_EQ(at(1, 0), 1);
  EXPECT_EQ(at(2, 0), 0) << "the gap";
  EXPECT_EQ(at(2 + kGridGap, 0), 2);
  EXPECT_EQ(at(0, 1 + kGridGap), 3);
  EXPECT_EQ(at(2 + kGridGap, 1 + kGridGap), 0) << "no fourth one";
  EXPECT_EQ(picture_grid({}, 3).width, 0u);
}

/// Films by a program that is called ffmpeg and does what the test says.
class film : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    path_before_ = std::getenv("PATH");
    ::setenv("PATH", (folder_.string() + ":/usr/bin:/bin").c_str(), 1);
  }
  void TearDown() override {
    ::setenv("PATH", path_before_.c_str(), 1);
    fs::remove_all(folder_);
  }
  void ffmpeg(const std::string& script) {
    std::ofstream(folder_ / "ffmpeg") << "#!/bin/sh\n" << script;
    ::chmod((folder_ / "ffmpeg").c_str(), 0755);
  }
  std::string file(const char* name) const { return (folder_ / name).string(); }

  fs::path folder_ = fs::temp_directory_path() / ("film" + std::to_string(::getpid()));
  std::string path_before_;
};

TEST_F(film, gives_each_picture_to_ffmpeg_and_appears_when_it_is_complete) {
  ffmpeg("for last; do :; done\ncat > \"${last#file:}\"\necho \"$@\" > '" + file("arguments") + "'\n");
  {
    FilmWriter writer(file("a:b.mp4"), 24.0);
    for (const int value : {7, 8, 9}) writer.write(plain(static_cast<std::uint8_t>(value)));
    EXPECT_FALSE(fs::exists(file("a:b.mp4")));
    EXPECT_EQ(writer.finish(), "");
  }
  EXPECT_EQ(test::text_of_file(file("a:b.mp4")),
            std::string(8, '\x07') + std::string(8, '\x08') + std::string(8, '\x09'));
  const std::string arguments = test::text_of_file(file("arguments"));
  EXPECT_THAT(arguments, HasSubstr("-pix_fmt rgba -s 2x1 -r 24 -i -"));
  EXPECT_THAT(arguments, HasSubstr("libx264"));
}

TEST_F(film, that_fails_leaves_no_file_and_says_why) {
  ffmpeg("for last; do :; done\ntouch \"${last#file:}\"\nexit 1\n");
  FilmWriter failing(file("a.webm"), 30.0);
  const Picture large{256, 256, std::vector<std::uint8_t>(256 * 256 * 4, 1)};
  for (int i = 0; i < 20; ++i) failing.write(large);  // more than a pipe holds
  EXPECT_THAT(failing.finish(), HasSubstr("a.webm: ffmpeg"));
  EXPECT_FALSE(fs::exists(file("a.webm")));
  EXPECT_FALSE(fs::exists(file("a.part.webm")));
  fs::remove(folder_ / "ffmpeg");
  ::setenv("PATH", folder_.c_str(), 1);
  FilmWriter missing(file("a.gif"), 30.0);
  missing.write(plain(1));
  EXPECT_THAT(missing.finish(), HasSubstr("films need the program ffmpeg"));
}

TEST_F(film, has_a_codec_for_each_ending) {
  EXPECT_TRUE(names_film("a.MP4") && names_film("a.webm") && names_film("a.gif"));
  EXPECT_FALSE(names_film("a.avi") || names_film("mp4"));
  const auto holds = [](const std::vector<std::string>& arguments, const char* word) {
    return std::find(arguments.begin(), arguments.end(), word) != arguments.end();
  };
  EXPECT_TRUE(holds(ffmpeg_arguments("a.webm", 3, 3, 30.0), "libvpx-vp9"));
  EXPECT_TRUE(holds(ffmpeg_arguments("a.gif", 3, 3, 12.5), "12.5"));
  for (const char* name : {"a.mp4", "a.webm", "a.gif"})
    EXPECT_TRUE(holds(ffmpeg_arguments(name, 3, 3, 30.0), "+bitexact")) << "the same bytes in each run";
}

}  // namespace
}  // namespace sinew::viewer
