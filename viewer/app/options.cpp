// SPDX-License-Identifier: MIT
#include "viewer/app/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "runtime/model/vertex_visibility.h"
#include "viewer/app/keys.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kLargestSide = 16384;  // every desktop device with Vulkan 1.3 supports it

// Parses all of `text` as a finite number; empty if that fails.
template <class T>
std::optional<T> number(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if constexpr (std::is_floating_point_v<T>)
    if (!std::isfinite(value)) return std::nullopt;
  return value;
}

// Parses two numbers with `separator` between them.
template <class T>
std::optional<std::pair<T, T>> two_numbers(std::string_view text, char separator) {
  const auto at = text.find(separator);
  if (at == std::string_view::npos) return std::nullopt;
  const auto a = number<T>(text.substr(0, at)), b = number<T>(text.substr(at + 1));
  if (!a || !b) return std::nullopt;
  return std::pair(*a, *b);
}

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

void read_frames(const std::string& text, Options& options) {
  const auto range = two_numbers<std::uint32_t>(text, ':');
  if (!range || range->first > range->second)
    throw CLI::ValidationError("--frames", "'" + text + "' is not FIRST:LAST with FIRST <= LAST, such as 0:59");
  options.frames = FrameRange{range->first, range->second};
}

bool names_png(const std::string& path) {
  if (path.size() < 4) return false;
  std::string end = path.substr(path.size() - 4);
  for (char& c : end) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
  return end == ".png";
}

// Checks rules between options that CLI11's needs() and excludes() cannot express.
void check_together(const Options& options) {
  if (options.camera && options.camera->eye == options.camera->target)
    throw CLI::ValidationError("--eye", "the camera cannot look at the same point that it is at");
  if (options.key_poses > 1 && options.occlusion_method != OcclusionMethod::rays)
    throw CLI::ValidationError("--key-poses", "rays are cast with --ao rays only");
  if (options.headless.empty()) return;
  if (options.frames && names_png(options.headless))
    throw CLI::ValidationError("--headless",
                               "'" + options.headless + "' is one picture, --frames needs a folder: DIR/");
  if (!options.frames && !names_png(options.headless))
    throw CLI::ValidationError(
        "--headless",
        "'" + options.headless + "' does not end in .png; for a folder of pictures add --frames FIRST:LAST --fps N");
}

// Looks `text` up in a table of names and values; an unknown name is a validation error that lists all names.
template <class T>
T named(const char* option, const std::string& text, std::initializer_list<std::pair<const char*, T>> names) {
  std::string all;
  for (const auto& [name, value] : names) {
    if (text == name) return value;
    all += (all.empty() ? "" : ", ") + std::string(name);
  }
  throw CLI::ValidationError(option, "'" + text + "' is not one of: " + all);
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

// Adds an option whose argument is passed to `read`.
template <class Read>
CLI::Option* text_option(CLI::App& app, const char* name, const char* type, const char* what, Read read) {
  return app.add_option_function<std::string>(name, read, what)->type_name(type);
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

void add_time_options(CLI::App& app, Options& options, CLI::Option* file) {
  const auto seconds = [](const char* option, const std::string& text, double least) {
    const auto value = number<double>(text);
    if (!value || *value < least) throw CLI::ValidationError(option, "'" + text + "' is not a time in seconds");
    return *value;
  };
  text_option(app, "--clip", "CLIP", "index, name, name#2 (the second of that name) or none (the first clip)",
              [&](const std::string& text) { options.clip = text; });
  auto* time = text_option(app, "--time", "T", "seconds into the clip (0)",
                           [&, seconds](const std::string& text) { options.time_s = seconds("--time", text, -1e9); });
  auto* headless =
      app.add_option("--headless", options.headless, "write OUT.png, or numbered pictures into DIR/, without a window")
          ->type_name("OUT");
  auto* frames = text_option(app, "--frames", "A:B", "pictures A to B, both included; picture n shows second n / fps",
                             [&](const std::string& text) { read_frames(text, options); });
  auto* fps = text_option(app, "--fps", "N", "pictures a second for --frames (30)", [&](const std::string& text) {
    const auto value = number<double>(text);
    if (!value || *value <= 0.0 || *value > 1e6)
      throw CLI::ValidationError("--fps", "'" + text + "' is not a rate above 0");
    options.fps = *value;
  });
  text_option(
      app, "--updates", "HOW",
      "what is small in the picture: every, interpolated or held between updates (interpolated; with --headless every)",
      [&](const std::string& text) {
        options.updates = named<Updates>(
            "--updates", text,
            {{"every", Updates::every}, {"interpolated", Updates::interpolated}, {"held", Updates::held}});
      });
  auto* plan = app.add_flag("--plan", options.plan,
                            "print what a picture takes: each stage and pass, why it runs or not, and its time");
  auto* transparent = app.add_flag("--transparent", options.transparent, "alpha 0 where nothing was drawn");
  auto* exit_after =
      text_option(app, "--exit-after", "SECONDS", "close the window by itself, for tests",
                  [&, seconds](const std::string& text) { options.exit_after_s = seconds("--exit-after", text, 0.0); });
  app.add_flag("--validate", options.validate, "use Vulkan's validation layer; exit code 3 when it complains");
  auto* watch = app.add_flag("--watch", options.watch,
                             "read FILE again when it or a file that it names changes; clip, time and camera stay");
  watch->needs(file)->excludes(headless);
  frames->needs(headless)->excludes(time);
  fps->needs(frames);
  transparent->needs(headless);
  plan->needs(headless);
  exit_after->excludes(headless);
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
      "Plays the animations of a glTF file in a window, or writes pictures of them.\n"
      "Without FILE it shows the built-in scenes.",
      "sinew-viewer"};
  app.formatter(std::make_shared<ShortFormatter>());
  app.set_version_flag("--version", "sinew-viewer " SINEW_VERSION);
  auto* file = app.add_option("FILE", options.file, "a .gltf or .glb file, or a geometry cache (.sgeo)")->type_name("");
  app.add_option("--scene", options.scene, "which scene of FILE (its default), or which built-in one (0)")
      ->type_name("N");
  add_cache_options(app, options, file);
  add_picture_options(app, options);
  add_light_options(app, options);
  add_time_options(app, options, file);
  app.footer(
      "Keys in the window:\n" + describe_keys() +
      "\nExit code: 0 done, 1 the file is at fault, 2 wrong usage, 3 no Vulkan device, or no display for the window\n"
      "Compiled pipelines and prepared light are kept for the next run in the folder that the environment variable\n"
      "SINEW_CACHE names (none = nowhere), else in sinew in the user's cache folder.\n");
  try {
    app.parse(argc, argv);
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
