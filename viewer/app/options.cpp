// SPDX-License-Identifier: MIT
#include "viewer/app/options.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "runtime/model/vertex_visibility.h"
#include "viewer/app/inspect/inspect_options.h"
#include "viewer/app/keys.h"
#include "viewer/app/motion_options.h"
#include "viewer/app/open/file_names.h"
#include "viewer/app/option_text.h"
#include "viewer/app/output_options.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kLargestSide = 16384;  // every desktop device with Vulkan 1.3 supports it

glm::vec3 point(const std::string& text, const char* option) {
  glm::vec3 p(0.0f);
  std::string_view rest = text;
  for (int i = 0; i < 3; ++i) {
    const auto comma = i < 2 ? rest.find(',') : rest.size();
    const auto value = comma == std::string_view::npos ? std::nullopt : number<float>(rest.substr(0, comma));
    if (!value) throw CLI::ValidationError(option, "'" + text + "' is not three numbers X,Y,Z");
    p[i] = *value;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return p;
}

void read_size(const std::string& text, Options& options) {
  const auto size = two_numbers<std::uint32_t>(text, 'x');
  if (!size || size->first < 1 || size->second < 1 || size->first > kLargestSide || size->second > kLargestSide)
    throw CLI::ValidationError("--size",
                               "'" + text + "' is not WIDTHxHEIGHT with sides of 1 to 16384, such as 1280x720");
  std::tie(options.width, options.height) = *size;
}

// Takes a panorama among the files as the light; the first of the others is FILE.
void sort_files(const std::vector<std::string>& files, bool environment_is_given, Options& options) {
  for (const std::string& file : files) {
    if (names_panorama(file)) {
      if (environment_is_given)
        throw CLI::ValidationError("FILE", "'" + file + "' is light, and --environment or another file is, too");
      environment_is_given = true;
      options.environment = file;
    } else if (options.file.empty()) {
      options.file = file;
    } else {
      options.more_files.push_back(file);
    }
  }
}

// Checks rules between options that CLI11's needs() and excludes() cannot express.
void check_together(const Options& options) {
  if (options.camera && options.camera->eye == options.camera->target)
    throw CLI::ValidationError("--eye", "the camera cannot look at the same point that it is at");
  if (options.key_poses > 1 && options.occlusion_method != OcclusionMethod::rays)
    throw CLI::ValidationError("--key-poses", "rays are cast with --ao rays only");
}

TextureFilter filter_named(const std::string& text) {
  constexpr std::string_view kAnisotropic = "anisotropic=";
  if (text.starts_with(kAnisotropic)) {
    const auto places = number<std::uint32_t>(std::string_view(text).substr(kAnisotropic.size()));
    if (!places || *places < 2 || *places > 16)
      throw CLI::ValidationError("--filter", "'" + text + "' is not anisotropic=N with N from 2 to 16");
    return {FilterKind::anisotropic, *places};
  }
  if (text == "anisotropic") throw CLI::ValidationError("--filter", "'" + text + "' lacks its places: anisotropic=8");
  return {named<FilterKind>("--filter", text,
                            {{"nearest", FilterKind::nearest},
                             {"bilinear", FilterKind::bilinear},
                             {"trilinear", FilterKind::trilinear},
                             {"ripmap", FilterKind::rip_map}})};
}

void add_picture_options(CLI::App& app, Options& options) {
  text_option(app, "--size", "WxH", "pixels of picture or window (1280x720)",
              [&](const std::string& text) { read_size(text, options); });
  text_option(app, "--skinning", "KIND", "linear, dual-quaternion or center-of-rotation (linear)",
              [&](const std::string& text) {
                options.skinning = named<Skinning>("--skinning", text,
                                                   {{"linear", Skinning::linear},
                                                    {"dual-quaternion", Skinning::dual_quaternion},
                                                    {"center-of-rotation", Skinning::center_of_rotation}});
              });
  text_option(app, "--show", "WHAT",
              "color, ao, normals, depth, or level: mip or rip levels of the base colour that are read (color)",
              [&](const std::string& text) {
                options.show = named<Show>("--show", text,
                                           {{"color", Show::color},
                                            {"ao", Show::ao},
                                            {"normals", Show::normals},
                                            {"depth", Show::depth},
                                            {"level", Show::level}});
              });
  text_option(
      app, "--filter", "HOW",
      "read all textures: nearest, bilinear (both without mip levels), trilinear, anisotropic=N (at N places, 2 to "
      "16) or ripmap (as the file says)",
      [&](const std::string& text) { options.filter = filter_named(text); });
  text_option(app, "--shading", "HOW",
              "physical, or gooch: cool to warm tones with outlines, without shadows and ambient light (physical)",
              [&](const std::string& text) {
                options.shading =
                    named<Shading>("--shading", text, {{"physical", Shading::physical}, {"gooch", Shading::gooch}});
              });
  text_option(app, "--normals", "HOW", "between vertices: interpolated, or quaternion (interpolated)",
              [&](const std::string& text) {
                options.normals = named<NormalInterpolation>("--normals", text,
                                                             {{"interpolated", NormalInterpolation::interpolated},
                                                              {"quaternion", NormalInterpolation::quaternion}});
              });
  text_option(app, "--transparency", "HOW",
              "blended surfaces: sorted, or weighted: in any order, for those that intersect (sorted)",
              [&](const std::string& text) {
                options.transparency = named<Transparency>(
                    "--transparency", text, {{"sorted", Transparency::sorted}, {"weighted", Transparency::weighted}});
              });
  auto* method = text_option(
      app, "--ao", "METHOD", "ambient occlusion: gtao (horizons), ssao (points around), or rays at vertices (gtao)",
      [&](const std::string& text) {
        options.occlusion_method = named<OcclusionMethod>(
            "--ao", text,
            {{"gtao", OcclusionMethod::gtao}, {"ssao", OcclusionMethod::ssao}, {"rays", OcclusionMethod::rays}});
      });
  text_option(app, "--key-poses", "N", "cast rays for N poses of the clip, blended while it plays (the rest pose)",
              [&](const std::string& text) {
                const auto count = number<std::uint32_t>(text);
                if (!count || *count < 2 || *count > kMostKeyPoses)
                  throw CLI::ValidationError(
                      "--key-poses", "'" + text + "' is not a number from 2 to " + std::to_string(kMostKeyPoses));
                options.key_poses = *count;
              })
      ->needs(method);
  app.add_flag_callback(
         "--no-ao", [&] { options.ambient_occlusion = false; }, "leave ambient occlusion out")
      ->excludes(method);
  text_option(app, "--smoothing", "HOW", "edges: on or off (on; off in a window that a software driver draws)",
              [&](const std::string& text) {
                options.smooth_edges = named<bool>("--smoothing", text, {{"on", true}, {"off", false}});
              });
  app.add_flag("--skeleton", options.skeleton, "draw the skeleton over the picture");
  auto* eye =
      text_option(app, "--eye", "X,Y,Z", "where the camera is (framing everything)", [&](const std::string& text) {
        if (!options.camera) options.camera.emplace();
        options.camera->eye = point(text, "--eye");
      });
  auto* target = text_option(app, "--target", "X,Y,Z", "what the camera looks at", [&](const std::string& text) {
    if (!options.camera) options.camera.emplace();
    options.camera->target = point(text, "--target");
  });
  auto* frame = text_option(app, "--frame", "WHAT", "what the camera frames: clip, pose, or follow to go along (clip)",
                            [&](const std::string& text) {
                              options.framing = named<Framing>(
                                  "--frame", text,
                                  {{"clip", Framing::clip}, {"pose", Framing::pose}, {"follow", Framing::follow}});
                            });
  frame->excludes(eye);
  eye->needs(target);
  target->needs(eye);
  auto* camera = text_option(app, "--camera", "CAMERA", "look through a camera of the file: index or name",
                             [&](const std::string& text) { options.file_camera = text; });
  camera->excludes(eye)->excludes(frame);
  text_option(app, "--variant", "VARIANT", "show a material variant of the file: index or name",
              [&](const std::string& text) { options.variant = text; });
  auto* fov = text_option(app, "--fov", "DEGREES", "vertical field of view (45)", [&](const std::string& text) {
    const auto degrees = number<double>(text);
    if (!degrees || *degrees < 1.0 || *degrees > 170.0)
      throw CLI::ValidationError("--fov", "'" + text + "' is not an angle of 1 to 170 degrees");
    options.fov_y_deg = *degrees;
  });
  camera->excludes(fov);
}

void add_light_options(CLI::App& app, Options& options) {
  const auto bounded = [](const char* option, const std::string& text, float least, float most, const char* what) {
    const auto value = number<float>(text);
    if (!value || *value < least || *value > most) throw CLI::ValidationError(option, "'" + text + "' is not " + what);
    return *value;
  };
  app.add_flag_callback(
      "--no-shadows", [&] { options.shadows = false; }, "leave shadows out");
  text_option(app, "--ground", "LOOK", "below the scene: none, shadows, or grid with them (shadows)",
              [&](const std::string& text) {
                options.ground = named<GroundLook>(
                    "--ground", text,
                    {{"none", GroundLook::none}, {"shadows", GroundLook::shadows}, {"grid", GroundLook::grid}});
              });
  app.add_option("--environment", options.environment,
                 "light from all around: studio, sunset, overcast, plain, none, or a panorama .hdr or .exr (studio)")
      ->type_name("LIGHT");
  text_option(app, "--environment-turn", "DEGREES", "turn it counter-clockwise, seen from above (0)",
              [&, bounded](const std::string& text) {
                options.environment_turn_deg =
                    bounded("--environment-turn", text, -360.0f, 360.0f, "an angle of -360 to 360 degrees");
              });
  text_option(app, "--environment-intensity", "X", "times as much of it (1)", [&, bounded](const std::string& text) {
    options.environment_intensity = bounded("--environment-intensity", text, 0.0f, 1e6f, "a factor from 0 on");
  });
  text_option(app, "--backdrop", "WHAT",
              "what is behind: plain, blurred or sharp light from all around (blurred; plain for gooch)",
              [&](const std::string& text) {
                options.backdrop = named<Backdrop>(
                    "--backdrop", text,
                    {{"plain", Backdrop::plain}, {"blurred", Backdrop::blurred}, {"sharp", Backdrop::sharp}});
              });
  text_option(
      app, "--tone", "CURVE", "how light is displayed: aces, neutral or none (aces)", [&](const std::string& text) {
        options.tone_curve = named<ToneCurve>(
            "--tone", text, {{"neutral", ToneCurve::neutral}, {"aces", ToneCurve::aces}, {"none", ToneCurve::none}});
      });
  text_option(app, "--exposure", "EV",
              "stops: 1 doubles all light, -1 halves it; auto follows the picture (0; auto where light clips a fifth "
              "of the model)",
              [&, bounded](const std::string& text) {
                options.auto_exposure = text == "auto";
                options.exposure_is_given = true;
                if (options.auto_exposure) return;
                options.exposure_ev =
                    bounded("--exposure", text, -32.0f, 32.0f, "auto or a number of stops from -32 to 32");
              });
}

void add_cache_options(CLI::App& app, Options& options, CLI::Option* file) {
  app.add_option("--cache", options.cache, "play a geometry cache (.sgeo) over FILE's meshes of the same names")
      ->type_name("OUT.sgeo")
      ->needs(file);
  text_option(app, "--cache-weight", "W", "0 shows the pose, 1 the geometry cache (1)", [&](const std::string& text) {
    const auto weight = number<float>(text);
    if (!weight || *weight < 0.0f || *weight > 1.0f)
      throw CLI::ValidationError("--cache-weight", "'" + text + "' is not a number from 0 to 1");
    options.cache_weight = *weight;
  });
}

// Omits CLI11's "Needs:" and "Excludes:" from the option column; the error message for a wrong combination names them.
class ShortFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_name().empty() ? "" : " " + option->get_type_name();
  }
};

}  // namespace

std::variant<Options, EarlyExit> parse_options(int argc, const char* const* argv) {
  Options options;
  CLI::App app{
      "Plays the animations of glTF files in a window, or writes pictures of them.\n"
      "Without FILE it shows the built-in scenes.",
      "sinew-viewer"};
  app.formatter(std::make_shared<ShortFormatter>());
  app.set_version_flag("--version", "sinew-viewer " SINEW_VERSION);
  std::vector<std::string> files;
  auto* file = app.add_option("FILE", files,
                              "characters and clip files (.gltf .glb .vrm .vrma .sinew), a geometry cache (.sgeo), "
                              "light (.hdr .exr), or folders of them; clips play on every character, retargeted where "
                              "skeletons differ")
                   ->type_name("...");
  app.add_option("--clips", options.clip_files, "take the clips alone of a file that has meshes, too; several times")
      ->type_name("FILE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->needs(file);
  app.add_option("--scene", options.scene, "which scene of FILE (its default), or which built-in one (0)")
      ->type_name("N");
  add_cache_options(app, options, file);
  add_picture_options(app, options);
  add_light_options(app, options);
  add_time_options(app, options, file);
  add_motion_options(app, options, file);
  add_inspect_options(app, options);
  app.footer(
      "Keys in the window:\n" + describe_keys() +
      "\nExit code: 0 done, 1 the file is at fault, 2 wrong usage, 3 no Vulkan device, or no display for the window\n"
      "Compiled pipelines and prepared light are kept for the next run in the folder that the environment variable\n"
      "SINEW_CACHE names (none = nowhere), else in sinew in the user's cache folder.\n");
  try {
    app.parse(argc, argv);
    check_outputs(app, options);
    sort_files(files, app.count("--environment") > 0, options);
    check_together(options);
  } catch (const CLI::CallForHelp&) {
    return EarlyExit{0, app.help()};
  } catch (const CLI::CallForVersion& version) {
    return EarlyExit{0, std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    return EarlyExit{2, "sinew-viewer: " + std::string(error.what()) + "\nsinew-viewer --help lists the options\n"};
  }
  return options;
}

}  // namespace sinew::viewer
