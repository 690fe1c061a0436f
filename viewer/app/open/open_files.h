// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "viewer/app/loaded_scene.h"

namespace sinew::viewer {

/// Files that were opened together, by their use.
struct OpenedFiles {
  std::vector<LoadedScene> characters;  ///< files with something to draw
  std::vector<LoadedScene> clips;       ///< files with clips alone, which other characters play (is_clip_file)
  std::vector<std::string> caches;      ///< paths of geometry caches
};

/// Opens files in their order. Options::scene counts for the first one.
/// err  the first error, and its location
tl::expected<OpenedFiles, LoadError> open_files(const std::vector<std::string>& files, const Options& options,
                                                const std::function<void(const std::string&)>& log_line,
                                                const std::function<void(double)>& progress);

/// Makes scenes of opened files. Every character gets the clips of all clip files; the first one also plays the
/// geometry cache. Without characters, clip files show their skeletons, and caches are scenes themselves.
/// err  a cache that does not bind; two caches for one character
tl::expected<std::vector<LoadedScene>, LoadError> combine_files(
    OpenedFiles opened, const std::function<void(const std::string&)>& log_line);

/// Prepares the rig of a scene whose clips are complete, with the options' graph if `takes_graph`.
/// err  a fault of the graph file, or a parameter that it lacks
tl::expected<void, LoadError> prepare_rig(LoadedScene& loaded, const Options& options, bool takes_graph,
                                          const std::function<void(const std::string&)>& log_line);

/// Opens the files that the options name, or creates the built-in scenes if they name none.
/// in   log_line  receives each warning as one line
///      progress  receives the finished fraction of the work, 0 to 1; may be empty
/// err  the error in the file, and its location
tl::expected<std::vector<LoadedScene>, LoadError> load_scenes(const Options& options,
                                                              const std::function<void(const std::string&)>& log_line,
                                                              const std::function<void(double)>& progress);

/// Opens the files again, as load_scenes does, but reuses the given environment light.
/// out  the first scene
/// err  the error in the file, and its location
tl::expected<LoadedScene, LoadError> reload_scene(const Options& options,
                                                  std::shared_ptr<const Environment> environment,
                                                  const std::function<void(const std::string&)>& log_line);

}  // namespace sinew::viewer
