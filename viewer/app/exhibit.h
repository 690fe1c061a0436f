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
#include "runtime/model/vertex_access.h"
#include "runtime/plan/needs.h"
#include "viewer/app/cache/cache_on_scene.h"
#include "viewer/app/options.h"
#include "viewer/app/update_levels.h"
#include "viewer/light/environment.h"

namespace sinew::viewer {

/// A scene to be shown: a file, or one of the built-in scenes.
struct Exhibit {
  std::string name;  ///< for the title and the menu
  std::string note;  ///< one sentence: what to look at; may be empty
  Scene scene;
  std::vector<std::filesystem::path> files;        ///< that it was read from; empty for a built-in scene
  std::shared_ptr<const CacheOnScene> cache;       ///< none = no geometry cache plays
  std::vector<Skinning> instance_skinning;         ///< as in Needs: the kind of skinning that the scene itself asks for
  std::shared_ptr<const Environment> environment;  ///< light from all around; null = none
  std::shared_ptr<const VertexAccess> access;      ///< ambient access of its vertices; null = none
  std::optional<PlacedCamera> camera;              ///< none = the camera frames everything
  double fov_y_rad = 0.785398163397448;
};

/// How the poses of an exhibit are evaluated.
struct Evaluation {
  Skinning skinning = Skinning::linear;
  Updates updates = Updates::every;
  bool stage_times = false;  ///< measured while the live plan is shown

  friend bool operator==(const Evaluation&, const Evaluation&) = default;
};

/// What the viewer asks the runtime for: vertices, and bounds for frustum culling.
Needs needs_of(const Exhibit& exhibit, const Evaluation& evaluation);

/// Duration of what plays beside each clip: of the geometry cache, else 0.
double cache_duration_s(const Exhibit& exhibit) noexcept;

/// Why there is nothing to show, and the exit code of the program.
struct LoadError {
  int exit_code = 1;
  std::string message;
};

/// Reads the file, or makes the built-in scenes when no file is named.
/// in   say  receives each warning as one line;   progress  receives the finished part of the work, 0 to 1; may be
///      empty
/// err  what is wrong with the file, and where
tl::expected<std::vector<Exhibit>, LoadError> load_exhibits(const Options& options,
                                                            const std::function<void(const std::string&)>& say,
                                                            const std::function<void(double)>& progress);

/// Reads the file of the options again, as load_exhibits does. It shows in the light from all around that is there.
/// err  what is wrong with the file, and where
tl::expected<Exhibit, LoadError> reload_exhibit(const Options& options, std::shared_ptr<const Environment> environment,
                                                const std::function<void(const std::string&)>& say);

/// Computes the centers of rotation of the scene's skinned meshes if `skinning` or the scene's own choice needs them
/// and they are not there yet. cost seconds for large meshes
void add_missing_centers(Exhibit& exhibit, Skinning skinning, const std::function<void(double)>& progress = {});

}  // namespace sinew::viewer
