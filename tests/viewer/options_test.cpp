// SPDX-License-Identifier: MIT
#include "viewer/app/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <tuple>

namespace sinew::viewer {
namespace {

using testing::HasSubstr;

std::variant<Options, EarlyExit> parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "sinew-viewer");
  return parse_options(static_cast<int>(arguments.size()), arguments.data());
}

Options accepted(std::vector<const char*> arguments) {
  const auto parsed = parse(std::move(arguments));
  if (const auto* leave = std::get_if<EarlyExit>(&parsed)) {
    ADD_FAILURE() << leave->text;
    return {};
  }
  return std::get<Options>(parsed);
}

TEST(options, without_arguments_open_a_window_on_the_showcase) {
  const Options options = accepted({});
  EXPECT_EQ(options.file, "");
  EXPECT_EQ(options.headless, "");
  EXPECT_EQ(options.first_scene(), 0u);
  EXPECT_EQ(options.width, 1280u);
  EXPECT_EQ(options.height, 720u);
  EXPECT_TRUE(options.ambient_occlusion && options.shadows);
  EXPECT_FALSE(accepted({"--no-shadows"}).shadows);
  EXPECT_EQ(options.occlusion_method, OcclusionMethod::gtao);
  EXPECT_EQ(accepted({"--ao", "ssao"}).occlusion_method, OcclusionMethod::ssao);
  EXPECT_EQ(accepted({"--ao", "gtao"}).occlusion_method, OcclusionMethod::gtao);
  EXPECT_EQ(accepted({"--ao", "rays"}).occlusion_method, OcclusionMethod::rays);
  EXPECT_EQ(options.key_poses, 1u);
  EXPECT_EQ(accepted({"--ao", "rays", "--key-poses", "8"}).key_poses, 8u);
  EXPECT_EQ(options.framing, Framing::clip);
  EXPECT_EQ(accepted({"--frame", "pose"}).framing, Framing::pose);
  EXPECT_EQ(accepted({"--frame", "follow"}).framing, Framing::follow);
  EXPECT_EQ(options.ground, GroundLook::shadows);
  EXPECT_EQ(accepted({"--ground", "none"}).ground, GroundLook::none);
  EXPECT_EQ(accepted({"--ground", "shadows"}).ground, GroundLook::shadows);
  EXPECT_EQ(accepted({"--ground", "grid"}).ground, GroundLook::grid);
  EXPECT_EQ(options.shading, Shading::physical);
  EXPECT_EQ(accepted({"--shading", "gooch"}).shading, Shading::gooch);
  EXPECT_EQ(accepted({"--shading", "physical"}).shading, Shading::physical);
  EXPECT_FALSE(options.watch);
  EXPECT_TRUE(accepted({"a.glb", "--watch"}).watch);
  EXPECT_TRUE(accepted({"--watch", "a.glb"}).watch);
  EXPECT_FALSE(options.smooth_edges.has_value());
  EXPECT_EQ(accepted({"--smoothing", "on"}).smooth_edges, true);
  EXPECT_EQ(accepted({"--smoothing", "off"}).smooth_edges, false);
  EXPECT_EQ(options.environment, "studio");
  EXPECT_FALSE(options.camera || options.time_s || options.frames || options.clip || options.fov_y_deg);
  EXPECT_EQ(options.tone_curve, ToneCurve::aces);
  EXPECT_FALSE(options.auto_exposure || options.exposure_is_given);
  EXPECT_TRUE(accepted({"--exposure", "0"}).exposure_is_given);
  EXPECT_TRUE(accepted({"--exposure", "auto"}).auto_exposure);
  EXPECT_FALSE(accepted({"--exposure", "1"}).auto_exposure);
  EXPECT_FALSE(options.exit_after_s || options.validate || options.transparent);
}

TEST(options, read_everything_that_one_picture_can_have) {
  const Options options = accepted({"a b.glb",
                                    "--headless",
                                    "out.PNG",
                                    "--time",
                                    "0.5",
                                    "--clip",
                                    "Run",
                                    "--size",
                                    "640x360",
                                    "--skinning",
                                    "dual-quaternion",
                                    "--show",
                                    "normals",
                                    "--eye",
                                    "-.5,1e1,-2",
                                    "--target",
                                    "0,0.25,3",
                                    "--fov",
                                    "30",
                                    "--transparent",
                                    "--no-ao",
                                    "--validate",
                                    "--environment",
                                    "sky.hdr",
                                    "--environment-turn",
                                    "-90",
                                    "--environment-intensity",
                                    "0.5",
                                    "--exposure",
                                    "1.5",
                                    "--backdrop",
                                    "sharp",
                                    "--tone",
                                    "aces"});
  EXPECT_EQ(options.environment, "sky.hdr");
  EXPECT_EQ(options.environment_turn_deg, -90.0f);
  EXPECT_EQ(options.environment_intensity, 0.5f);
  EXPECT_EQ(options.exposure_ev, 1.5f);
  EXPECT_EQ(options.backdrop, Backdrop::sharp);
  EXPECT_EQ(options.tone_curve, ToneCurve::aces);
  EXPECT_EQ(options.file, "a b.glb");
  EXPECT_EQ(options.headless, "out.PNG");
  EXPECT_EQ(options.time_s, 0.5);
  EXPECT_EQ(options.clip, "Run");
  EXPECT_EQ(options.width, 640u);
  EXPECT_EQ(options.height, 360u);
  EXPECT_EQ(options.skinning, Skinning::dual_quaternion);
  EXPECT_EQ(options.show, Show::normals);
  ASSERT_TRUE(options.camera);
  EXPECT_EQ(options.camera->eye, glm::vec3(-0.5f, 10.0f, -2.0f));
  EXPECT_EQ(options.camera->target, glm::vec3(0.0f, 0.25f, 3.0f));
  EXPECT_EQ(options.fov_y_deg, 30.0);
  EXPECT_TRUE(options.transparent);
  EXPECT_FALSE(options.ambient_occlusion);
  EXPECT_TRUE(options.validate);
}

TEST(options, sides_of_pictures_are_1_to_16384) {
  for (const auto& [text, width, height] :
       {std::tuple{"16384x1", 16384u, 1u}, {"1x16384", 1u, 16384u}, {"16384x16384", 16384u, 16384u}}) {
    const Options options = accepted({"--headless", "out.png", "--size", text});
    EXPECT_EQ(options.width, width) << text;
    EXPECT_EQ(options.height, height) << text;
  }
}

TEST(options, read_a_camera_and_a_variant_of_the_file) {
  const Options options = accepted({"a.glb", "--camera", "Front", "--variant", "1"});
  EXPECT_EQ(options.file_camera, "Front");
  EXPECT_EQ(options.variant, "1");
  EXPECT_TRUE(
      std::holds_alternative<EarlyExit>(parse({"a.glb", "--camera", "0", "--eye", "0,0,1", "--target", "0,0,0"})));
}

TEST(options, read_points_with_or_without_a_digit_before_their_point) {
  const Options options = accepted({"--eye", "-.5,1,-2.5", "--target", "-0.25,.5,3"});
  ASSERT_TRUE(options.camera);
  EXPECT_EQ(options.camera->eye, glm::vec3(-0.5f, 1.0f, -2.5f));
  EXPECT_EQ(options.camera->target, glm::vec3(-0.25f, 0.5f, 3.0f));
  EXPECT_EQ(accepted({"--exposure", "-.5"}).exposure_ev, -0.5f);
}

TEST(options, read_a_geometry_cache_and_its_weight) {
  const Options options = accepted({"a.glb", "--cache", "b.sgeo", "--cache-weight", "0.25"});
  EXPECT_EQ(options.file, "a.glb");
  EXPECT_EQ(options.cache, "b.sgeo");
  EXPECT_EQ(options.cache_weight, 0.25f);
  EXPECT_EQ(accepted({"b.sgeo"}).cache, "") << "a cache alone is the file";
  EXPECT_EQ(accepted({}).cache_weight, 1.0f);
  EXPECT_EQ(accepted({"--scene", "3", "--cache-weight", "0"}).cache_weight, 0.0f) << "for the built-in flag";
}

TEST(options, read_what_is_written_in_place_of_one_picture) {
  const Options film = accepted({"a.glb", "--film", "A.MP4", "--turntable", "24", "--fps", "12"});
  EXPECT_EQ(film.film, "A.MP4");
  EXPECT_EQ(film.headless, film.film) << "so no window opens";
  EXPECT_EQ(film.turntable, 24u);
  const Options sheet = accepted({"a.glb", "--sheet", "all.png"});
  EXPECT_EQ(sheet.width, 240u);
  EXPECT_EQ(accepted({"a.glb", "--sheet", "all.png", "--size", "64x48"}).width, 64u);
  EXPECT_EQ(accepted({"a.glb", "--headless", "d/", "--turntable", "3"}).turntable, 3u);
  const std::vector<std::vector<const char*>> refused = {{"--film", "a.mp4"},
                                                         {"--film", "a.avi", "--turntable", "3"},
                                                         {"--film", "a.gif", "--frames", "0:3", "--headless", "d/"},
                                                         {"--turntable", "3"},
                                                         {"--turntable", "1", "--headless", "d/"},
                                                         {"--turntable", "3", "--headless", "a.png"},
                                                         {"--turntable", "3", "--frames", "0:3", "--headless", "d/"},
                                                         {"--compare", "linear,dual-quaternion"},
                                                         {"--sheet", "all.jpg"},
                                                         {"--sheet", "all.png", "--time", "1"}};
  for (const auto& arguments : refused)
    EXPECT_TRUE(std::holds_alternative<EarlyExit>(parse(arguments))) << arguments[0] << " " << arguments[1];
}

TEST(options, sort_several_files_by_their_use) {
  const Options options = accepted({"a.glb", "Sky.HDR", "walk.glb", "--clips", "b.glb", "c.sinew", "--clips", "d.glb"});
  EXPECT_EQ(options.file, "a.glb");
  EXPECT_EQ(options.more_files, (std::vector<std::string>{"walk.glb", "c.sinew"}));
  EXPECT_EQ(options.clip_files, (std::vector<std::string>{"b.glb", "d.glb"}));
  EXPECT_EQ(options.environment, "Sky.HDR");
  EXPECT_EQ(accepted({"sky.exr"}).file, "") << "light alone falls on the built-in scenes";
  EXPECT_TRUE(std::holds_alternative<EarlyExit>(parse({"a.glb", "a.hdr", "b.exr"}))) << "two lights";
  EXPECT_TRUE(std::holds_alternative<EarlyExit>(parse({"a.glb", "a.hdr", "--environment", "none"})));
  EXPECT_TRUE(std::holds_alternative<EarlyExit>(parse({"--clips", "b.glb"}))) << "nobody plays them";
}

TEST(options, read_a_range_of_pictures) {
  const Options options = accepted({"--scene", "2", "--headless", "out/", "--frames", "3:16", "--fps", "2.5"});
  EXPECT_EQ(options.first_scene(), 2u);
  EXPECT_EQ(accepted({"a.glb", "--scene", "1"}).scene, 1u);
  EXPECT_EQ(accepted({"a.glb", "--scene", "1"}).first_scene(), 0u) << "a file is one scene";
  ASSERT_TRUE(options.frames);
  EXPECT_EQ(options.frames->first, 3u);
  EXPECT_EQ(options.frames->last, 16u);
  EXPECT_EQ(options.fps, 2.5);
}

TEST(options, accept_each_filter_of_textures) {
  EXPECT_EQ(accepted({}).filter, TextureFilter{});
  EXPECT_EQ(accepted({"--filter", "nearest"}).filter.kind, FilterKind::nearest);
  EXPECT_EQ(accepted({"--filter", "bilinear"}).filter.kind, FilterKind::bilinear);
  EXPECT_EQ(accepted({"--filter", "trilinear"}).filter.kind, FilterKind::trilinear);
  EXPECT_EQ(accepted({"--filter", "ripmap"}).filter.kind, FilterKind::rip_map);
  EXPECT_EQ(accepted({"--filter", "anisotropic=16"}).filter, (TextureFilter{FilterKind::anisotropic, 16}));
}

TEST(options, accept_each_order_of_what_blends) {
  EXPECT_EQ(accepted({}).transparency, Transparency::sorted);
  EXPECT_EQ(accepted({"--transparency", "sorted"}).transparency, Transparency::sorted);
  EXPECT_EQ(accepted({"--transparency", "weighted"}).transparency, Transparency::weighted);
}

TEST(options, accept_each_interpolation_of_normals) {
  EXPECT_EQ(accepted({}).normals, NormalInterpolation::interpolated);
  EXPECT_EQ(accepted({"--normals", "interpolated"}).normals, NormalInterpolation::interpolated);
  EXPECT_EQ(accepted({"--normals", "quaternion"}).normals, NormalInterpolation::quaternion);
}

TEST(options, accept_each_word_of_show_and_skinning) {
  EXPECT_EQ(accepted({"--show", "color"}).show, Show::color);
  EXPECT_EQ(accepted({"--show", "ao"}).show, Show::ao);
  EXPECT_EQ(accepted({"--show", "depth"}).show, Show::depth);
  EXPECT_EQ(accepted({"--show", "level"}).show, Show::level);
  EXPECT_EQ(accepted({"--skinning", "linear"}).skinning, Skinning::linear);
  EXPECT_EQ(accepted({"--skinning", "center-of-rotation"}).skinning, Skinning::center_of_rotation);
}

struct WrongUsage {
  std::vector<const char*> arguments;
  const char* says;  // text that the message must contain
};

TEST(options, read_how_what_is_small_is_updated) {
  EXPECT_FALSE(accepted({}).updates);
  EXPECT_EQ(accepted({"--updates", "every"}).updates, Updates::every);
  EXPECT_EQ(accepted({"--updates", "interpolated"}).updates, Updates::interpolated);
  EXPECT_EQ(accepted({"--headless", "d/", "--frames", "0:9", "--updates", "held"}).updates, Updates::held);
  const auto refused = parse({"--updates", "sometimes"});
  ASSERT_TRUE(std::holds_alternative<EarlyExit>(refused));
  EXPECT_EQ(std::get<EarlyExit>(refused).code, 2);
  EXPECT_THAT(std::get<EarlyExit>(refused).text, HasSubstr("every, interpolated, held"));
}

TEST(options, refuse_wrong_usage_with_code_2_and_name_the_place) {
  const WrongUsage cases[] = {
      {{"--bogus"}, "--bogus"},
      {{"--scene", "-1"}, "--scene"},
      {{"--cache", "b.sgeo"}, "--cache"},
      {{"--cache-weight", "1.5"}, "1.5"},
      {{"--cache-weight", "half"}, "half"},
      {{"--size", "0x5"}, "0x5"},
      {{"--exposure", "bright"}, "bright"},
      {{"--exposure", "33"}, "33"},
      {{"--backdrop", "blue"}, "plain, blurred, sharp"},
      {{"--smoothing", "maybe"}, "on, off"},
      {{"--tone", "film"}, "neutral, aces, none"},
      {{"--environment-turn", "361"}, "361"},
      {{"--environment-intensity", "-1"}, "-1"},
      {{"--size", "640"}, "640"},
      {{"--size", "16385x2"}, "16385x2"},
      {{"--size", "2x16385"}, "2x16385"},
      {{"--size", "640x360x"}, "640x360x"},
      {{"--skinning", "cubic"}, "linear, dual-quaternion, center-of-rotation"},
      {{"--normals", "slerp"}, "interpolated, quaternion"},
      {{"--transparency", "peeled"}, "sorted, weighted"},
      {{"--filter", "linear"}, "nearest, bilinear, trilinear, ripmap"},
      {{"--filter", "anisotropic"}, "anisotropic=8"},
      {{"--filter", "anisotropic=1"}, "2 to 16"},
      {{"--filter", "anisotropic=17"}, "2 to 16"},
      {{"--filter", "anisotropic=4x"}, "2 to 16"},
      {{"--show", "colour"}, "color, ao, normals, depth, level"},
      {{"--eye", "1,2,3"}, "--target"},
      {{"--target", "1,2,3"}, "--eye"},
      {{"--eye", "1,2", "--target", "0,0,0"}, "X,Y,Z"},
      {{"--eye", "1,2,3,4", "--target", "0,0,0"}, "X,Y,Z"},
      {{"--eye", "1,2,nan", "--target", "0,0,0"}, "X,Y,Z"},
      {{"--eye", "1,1,1", "--target", "1,1,1"}, "same point"},
      {{"--fov", "0"}, "degrees"},
      {{"--fov", "180"}, "degrees"},
      {{"--time", "soon"}, "soon"},
      {{"--time", "inf"}, "inf"},
      {{"a", "--headless", "d/", "--frames", "0:3", "--time", "1"}, "--time"},
      {{"a", "--headless", "d/", "--frames", "4:3"}, "4:3"},
      {{"a", "--headless", "d/", "--frames", "-1:3"}, "-1:3"},
      {{"a", "--headless", "d/", "--frames", "0:3", "--fps", "0"}, "--fps"},
      {{"a", "--headless", "d/"}, "--frames"},
      {{"a", "--headless", "d.png", "--frames", "0:3"}, "folder"},
      {{"a", "--frames", "0:3"}, "--headless"},
      {{"a", "--headless", "d.png", "--fps", "3"}, "--frames"},
      {{"a", "--transparent"}, "--headless"},
      {{"a", "--headless", "d.png", "--exit-after", "3"}, "--exit-after"},
      {{"--exit-after", "-1"}, "--exit-after"},
      {{"--watch"}, "FILE"},
      {{"a", "--watch", "--headless", "d.png"}, "--watch"},
      {{"--headless"}, "--headless"},
  };
  for (const auto& wrong : cases) {
    std::string line;
    for (const char* argument : wrong.arguments) line += std::string(argument) + " ";
    SCOPED_TRACE(line);
    const auto parsed = parse(wrong.arguments);
    const auto* leave = std::get_if<EarlyExit>(&parsed);
    ASSERT_NE(leave, nullptr);
    EXPECT_EQ(leave->code, 2);
    EXPECT_THAT(leave->text, HasSubstr(wrong.says));
    EXPECT_THAT(leave->text, HasSubstr("--help"));
  }
}

struct Limits {
  std::vector<const char*> before;  ///< other options that it requires
  const char* option;
  std::vector<const char*> within, beyond;
};

TEST(options, numbers_are_taken_up_to_their_limits_and_no_further) {
  const std::vector<const char*> range = {"a", "--headless", "d/", "--frames", "0:3"};
  for (const auto& [before, option, within, beyond] :
       {Limits{{}, "--fov", {"1", "170"}, {"0.999", "170.001"}},
        {{}, "--exposure", {"-32", "32"}, {"-32.001", "32.001"}},
        {{}, "--environment-turn", {"-360", "360"}, {"-360.1", "360.1"}},
        {{}, "--environment-intensity", {"0", "1e6"}, {"-0.001", "1000001"}},
        {{}, "--cache-weight", {"0", "1"}, {"-0.001", "1.001"}},
        {{"--ao", "rays"}, "--key-poses", {"2", "64"}, {"1", "65", "2.5"}},
        {range, "--fps", {"0.001", "1e6"}, {"0", "-1", "1000001"}},
        {{}, "--exit-after", {"0", "1e9"}, {"-0.001"}},
        {{}, "--time", {"-1e9", "0", "1e9"}, {"-1000000001"}},
        {{}, "--filter", {"anisotropic=2", "anisotropic=16"}, {"anisotropic=1", "anisotropic=17"}},
        {{"a", "--headless", "d/"},
         "--frames",
         {"0:0", "3:3", "0:4294967295"},
         {"1:0", "0:4294967296", "0:1:2", ":1", "1:"}}}) {
    const auto with = [&, before_ = before, option_ = option](const char* value) {
      std::vector<const char*> arguments = before_;
      arguments.insert(arguments.end(), {option_, value});
      return std::holds_alternative<Options>(parse(arguments));
    };
    for (const char* value : within) EXPECT_TRUE(with(value)) << option << ' ' << value;
    for (const char* value : beyond) EXPECT_FALSE(with(value)) << option << ' ' << value;
  }
}

TEST(options, that_need_or_exclude_each_other_say_so) {
  const auto is_refused = [](const std::vector<const char*>& arguments) {
    const auto parsed = parse(arguments);
    const auto* leave = std::get_if<EarlyExit>(&parsed);
    return leave != nullptr && leave->code == 2;
  };
  for (const std::vector<const char*>& wrong :
       std::vector<std::vector<const char*>>{{"--eye", "1,2,3"},
                                             {"--target", "1,2,3"},
                                             {"--frame", "pose", "--eye", "1,2,3", "--target", "0,0,0"},
                                             {"a", "--camera", "0", "--eye", "1,2,3", "--target", "0,0,0"},
                                             {"a", "--camera", "0", "--frame", "pose"},
                                             {"a", "--camera", "0", "--fov", "30"},
                                             {"--no-ao", "--ao", "gtao"},
                                             {"--key-poses", "4"},
                                             {"--ao", "gtao", "--key-poses", "4"},
                                             {"--cache", "b.sgeo"},
                                             {"--watch"},
                                             {"a", "--watch", "--headless", "d.png"},
                                             {"a", "--frames", "0:3"},
                                             {"a", "--headless", "d/", "--frames", "0:3", "--time", "1"},
                                             {"a", "--headless", "d.png", "--fps", "3"},
                                             {"--transparent"},
                                             {"--plan"},
                                             {"--exit-after", "3", "--headless", "d.png"}})
    EXPECT_TRUE(is_refused(wrong)) << testing::PrintToString(wrong);
  for (const std::vector<const char*>& right : std::vector<std::vector<const char*>>{
           {"--eye", "1,2,3", "--target", "0,0,0", "--fov", "30"},
           {"a", "--camera", "0", "--variant", "1"},
           {"--frame", "pose", "--fov", "30"},
           {"--ao", "rays", "--key-poses", "4"},
           {"a", "--headless", "d/", "--frames", "0:3", "--fps", "3", "--transparent", "--plan"},
           {"a", "--watch", "--exit-after", "3"}})
    EXPECT_FALSE(is_refused(right)) << testing::PrintToString(right);
}

TEST(options, help_has_a_line_for_each_with_what_it_takes) {
  const std::string help = std::get<EarlyExit>(parse({"--help"})).text;
  std::istringstream lines(help.substr(help.find("\nOptions:\n")));
  std::vector<std::string> found;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  -")) continue;
    const std::size_t end = line.find("  ", 2);
    ASSERT_NE(end, line.npos) << line;
    found.push_back(line.substr(2, end - 2));
    EXPECT_GT(line.size(), line.find_first_not_of(' ', end) + 10) << "what it is: " << line;
  }
  EXPECT_THAT(found,
              testing::ElementsAre(
                  "-h,--help", "--version", "--clips FILE", "--scene N", "--cache OUT.sgeo", "--cache-weight W",
                  "--size WxH", "--skinning KIND", "--show WHAT", "--filter HOW", "--shading HOW", "--normals HOW",
                  "--transparency HOW", "--ao METHOD", "--key-poses N", "--no-ao", "--smoothing HOW", "--skeleton",
                  "--eye X,Y,Z", "--target X,Y,Z", "--frame WHAT", "--camera CAMERA", "--variant VARIANT",
                  "--fov DEGREES", "--no-shadows", "--ground LOOK", "--environment LIGHT", "--environment-turn DEGREES",
                  "--environment-intensity X", "--backdrop WHAT", "--tone CURVE", "--exposure EV", "--clip CLIP",
                  "--time T", "--headless OUT", "--frames A:B", "--fps N", "--updates HOW", "--plan", "--transparent",
                  "--exit-after SECONDS", "--validate", "--watch", "--film OUT", "--turntable N", "--sheet OUT",
                  "--compare VIEWS", "--layer CLIP,...", "--mirror", "--root HOW", "--fade SECONDS", "--no-springs",
                  "--graph GRAPH", "--set NAME=V@T", "--joint JOINT", "--overlay WHAT,...", "--paint WHAT"));
}

TEST(options, help_and_version_leave_with_code_0) {
  const auto help = std::get<EarlyExit>(parse({"--help"}));
  EXPECT_EQ(help.code, 0);
  for (const char* word : {"space", "play / pause", "skeleton", "Exit code"}) EXPECT_THAT(help.text, HasSubstr(word));
  const auto version = std::get<EarlyExit>(parse({"--version"}));
  EXPECT_EQ(version.code, 0);
  EXPECT_THAT(version.text, testing::MatchesRegex("sinew-viewer [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

}  // namespace
}  // namespace sinew::viewer
