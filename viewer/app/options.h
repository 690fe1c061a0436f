// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "importer/graph/graph_setting.h"
#include "runtime/plan/needs.h"
#include "viewer/app/camera/framing.h"
#include "viewer/app/inspect/inspected.h"
#include "viewer/app/motion/layer_choice.h"
#include "viewer/app/update_levels.h"
#include "viewer/device/disk_cache.h"
#include "viewer/passes/render_options.h"
#include "viewer/upload/texture_filter.h"

namespace sinew::viewer {

/// Numbered pictures `first` to `last`, both included. Picture n shows time n / fps.
struct FrameRange {
  std::uint32_t first = 0, last = 0;
};

/// A camera position given by the user, or by a built-in scene.
struct PlacedCamera {
  glm::vec3 eye{0.0f}, target{0.0f};
};

/// The command line of sinew-viewer, checked.
struct Options {
  std::string file;                     ///< a model, clips or a geometry cache; empty = the built-in showcase
  std::vector<std::string> more_files;  ///< further characters and clip files (open_files.h)
  std::vector<std::string> clip_files;  ///< files of which the clips alone are taken
  std::optional<std::uint32_t> scene;   ///< index of a built-in scene, or of a scene of FILE

  /// Index of the loaded scene to show first. A file counts as one loaded scene, so it is 0 for files.
  std::uint32_t first_scene() const noexcept { return file.empty() ? scene.value_or(0) : 0; }
  bool watch = false;            ///< read the file again when it changes
  std::string cache;             ///< a geometry cache that plays over the meshes of the file; empty = none
  float cache_weight = 1.0f;     ///< [0, 1] 0 = the pose, 1 = the cache
  std::string headless;          ///< OUT.png, or a folder together with `frames`; empty = window
  std::optional<double> time_s;  ///< unset = 0
  std::optional<FrameRange> frames;
  std::uint32_t turntable = 0;  ///< pictures of a turn around the scene; 0 = none
  std::string film, sheet;  ///< files to write instead of pictures; check_outputs() also copies the name to `headless`
  std::string compare;      ///< views of one moment side by side (parse_views); empty = one view

  /// True if several pictures are written.
  bool is_sequence() const noexcept { return frames || turntable > 0; }
  double fps = 30.0;
  std::vector<LayerText> layers;  ///< on top of the clip
  bool mirrored = false;          ///< the clip plays with left and right exchanged
  RootPlay root = RootPlay::as_in_clip;
  float fade_s = 0.0f;  ///< cross-fade after another clip is chosen in the window
  bool springs = true;  ///< springs and constraints of a VRM file move
  std::string graph;    ///< a motion graph (JSON) that drives the character; empty = clips play
  std::vector<GraphSetting> graph_script;
  std::optional<std::string> clip;  ///< index, name or "none"; unset = the first clip
  std::uint32_t width = 1280, height = 720;
  Skinning skinning = Skinning::linear;
  Show show = Show::color;
  TextureFilter filter;
  Shading shading = Shading::physical;
  NormalInterpolation normals = NormalInterpolation::interpolated;
  Transparency transparency = Transparency::sorted;
  bool ambient_occlusion = true;
  OcclusionMethod occlusion_method = AmbientOcclusion{}.method;
  std::uint32_t key_poses = 1;  ///< number of poses of the clip for which rays are cast; 1 = the rest pose
  bool shadows = true;
  GroundLook ground = GroundLook::shadows;
  std::optional<bool> smooth_edges;    ///< unset = on, except in a window drawn by a software driver
  std::string environment = "studio";  ///< a room, plain, none, or the file of a panorama
  float environment_turn_deg = 0.0f;   ///< rotation about +y, counter-clockwise seen from above
  float environment_intensity = 1.0f;
  std::optional<Backdrop> backdrop;  ///< unset = blurred; plain behind Gooch shading
  ToneCurve tone_curve = ToneCurve::aces;
  float exposure_ev = 0.0f;  ///< stops: 1 doubles the light
  bool auto_exposure = false;
  bool exposure_is_given = false;    ///< the command line names an exposure, so it is never adapted
  bool skeleton = false;             ///< draw skeleton lines over the picture
  std::optional<std::string> joint;  ///< index or name of the joint that is looked at
  Inspected inspected;               ///< without joint and vertex, which settings_from sets
  bool transparent = false;
  std::optional<PlacedCamera> camera;
  Framing framing = Framing::clip;
  std::optional<std::string> file_camera;  ///< index or name of a camera of the file
  std::optional<std::string> variant;      ///< index or name of a material variant
  std::optional<double> fov_y_deg;         ///< unset = 45, or the angle of the built-in scene
  std::optional<double> exit_after_s;      ///< close the window after this time
  /// Update rate of meshes that are small in the picture; unset = interpolated in the window, every in pictures.
  std::optional<Updates> updates;
  bool plan = false;      ///< print the live plan after the pictures
  DiskCache disk_cache;   ///< off after parse_options; main() sets the user's cache folder
  bool validate = false;  ///< use Vulkan's validation layer; any message of it gives exit code 3
};

/// Tells main() to print `text` and exit: help and version (code 0, stdout), or wrong usage (code 2, stderr).
struct EarlyExit {
  int code = 0;
  std::string text;
};

/// Parses the command line. Opens no file.
/// in   argc, argv  as passed to main()
std::variant<Options, EarlyExit> parse_options(int argc, const char* const* argv);

}  // namespace sinew::viewer
