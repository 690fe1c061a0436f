// SPDX-License-Identifier: MIT
#pragma once
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/app/open/open_files.h"

namespace sinew::viewer {

/// Files that were dropped on the window, opened.
struct DroppedFiles {
  OpenedFiles files;
  std::shared_ptr<const Environment> environment;  ///< of the last panorama among them; null = there was none
  std::vector<std::string> messages;               ///< warnings, and the error of each file that cannot be opened
};

/// Opens dropped files on another thread, so that the window goes on playing.
class FileDrop {
 public:
  /// Adds files and folders to those that wait to be opened.
  void add(std::vector<std::string> paths);

  /// Begins to open what waits, unless files are being opened. Returns the result of finished work, once.
  /// in   options  copied
  std::optional<DroppedFiles> follow(const Options& options);

  bool running() const noexcept { return result_.valid(); }

 private:
  std::vector<std::string> waiting_;
  std::future<DroppedFiles> result_;  ///< from std::async, so its destructor waits for the thread
};

/// Opens files and folders. A file that cannot be opened does not keep others from being shown.
DroppedFiles open_dropped(const std::vector<std::string>& paths, const Options& options);

/// The change that dropped files make to what is shown.
struct DropOutcome {
  std::vector<LoadedScene> new_scenes;    ///< characters, and caches that no mesh of the shown scene fits
  std::optional<LoadedScene> changed;     ///< the shown scene with more clips, or with a geometry cache
  std::optional<std::uint32_t> new_clip;  ///< the first clip that `changed` has gained
  std::vector<std::string> added_files;   ///< the files that `changed` has gained
  std::vector<std::string> messages;      ///< further warnings
};

/// Decides what dropped files do: characters become scenes and get the clips that were dropped with them. Without a
/// character, the shown scene gets clips and cache.
/// in   options  of the graph that drives the shown scene, if one does
DropOutcome apply_dropped(DroppedFiles dropped, const LoadedScene& shown, const Options& options);

}  // namespace sinew::viewer
