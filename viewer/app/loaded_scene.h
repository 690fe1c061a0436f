// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/model/scene.h"
#include "runtime/model/vertex_visibility.h"
#include "runtime/plan/needs.h"
#include "viewer/app/cache/cache_on_scene.h"
#include "viewer/app/motion/motion.h"
#include "viewer/app/options.h"
#include "viewer/app/update_levels.h"
#include "viewer/light/environment.h"

namespace sinew {
struct VrmCharacter;
}

namespace sinew::viewer {

/// A scene and all that belongs to its display. It comes from a file or is one of the built-in showcase scenes.
struct LoadedScene {
  std::string name;  ///< for the window title and the scene menu
  std::string note;  ///< one sentence that tells the user what to look at; may be empty
  Scene scene;
  std::vector<std::filesystem::path> files;   ///< files it was read from; empty for a built-in scene
  std::vector<std::string> messages;          ///< warnings of these files, for the window
  std::shared_ptr<const VrmCharacter> vrm;    ///< humanoid bones, springs and expressions; null = the file has none
  std::shared_ptr<const CacheOnScene> cache;  ///< null = no geometry cache plays
  std::shared_ptr<const CharacterRig> rig;    ///< root joint, springs, expressions and graph; null = none
  std::vector<Skinning> instance_skinning;    ///< per-instance skinning method, as in Needs; empty = the user's choice
  std::shared_ptr<const Environment> environment;      ///< environment light; null = none
  std::shared_ptr<const VertexVisibility> visibility;  ///< baked per-vertex ambient visibility; null = none
  std::optional<PlacedCamera> camera;                  ///< unset = the camera frames the whole scene
  double fov_y_rad = 0.785398163397448;
  double facing_yaw_rad = 0.0;  ///< from +z to the side that the model faces, about +y; framing looks at that side
};

/// User settings that decide how the poses of a scene are evaluated.
struct Evaluation {
  Skinning skinning = Skinning::linear;
  Updates updates = Updates::every;
  bool stage_times = false;  ///< measure the time of each stage; true while the live plan is shown
  MotionShape motion = {};   ///< tables that layers, graphs and springs need

  friend bool operator==(const Evaluation&, const Evaluation&) = default;
};

/// The runtime outputs that the viewer needs: deformed vertices, and bounds for frustum culling.
Needs needs_of(const LoadedScene& loaded, const Evaluation& evaluation);

/// The names of scenes, for a menu.
std::vector<std::string> names_of(const std::vector<LoadedScene>& scenes);

/// Duration of the geometry cache, which plays together with each clip; 0 without one.
double cache_duration_s(const LoadedScene& loaded) noexcept;

/// Why loading failed, and the exit code that the program should return.
struct LoadError {
  int exit_code = 1;
  std::string message;
};

/// Reads one file: glTF, an asset file (.sinew) or a geometry cache (.sgeo). Its kind is told by its first bytes.
/// in   options  Options::scene chooses a scene of a glTF file, the default scene if unset; Options::occlusion_method says if
///                  baked visibility is read
///      log_line  receives each warning as one line, which LoadedScene::messages has, too
///      progress  receives the finished fraction of the work, 0 to 1; may be empty
/// err  the error in the file, and its location
tl::expected<LoadedScene, LoadError> load_file(const std::string& file, const Options& options,
                                               const std::function<void(const std::string&)>& log_line,
                                               const std::function<void(double)>& progress);

/// Lets a geometry cache play over the meshes of the same names.
/// err  the error in the cache; or no mesh binds
tl::expected<void, LoadError> play_cache(const std::string& cache, LoadedScene& loaded,
                                         const std::function<void(const std::string&)>& log_line);

/// Computes missing centers of rotation for the skinned meshes, if `skinning` or the scene's own per-instance choice
/// needs them.
/// cost seconds for large meshes
void add_missing_centers(LoadedScene& loaded, Skinning skinning, const std::function<void(double)>& progress = {});

}  // namespace sinew::viewer
