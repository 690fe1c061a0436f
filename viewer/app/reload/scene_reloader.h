// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "viewer/app/reload/background_reload.h"
#include "viewer/app/reload/file_watch.h"

namespace sinew::viewer {

/// Watches the files of a scene and reloads it when they change.
///
/// After a failed reload, new files in the folder also count as changes, because the failure does not tell which file
/// was missing. Files that already exist do not count: the program's own log may be among them.
class SceneReloader {
 public:
  /// Construct it before the scene is first loaded, so that a change during loading is noticed.
  explicit SceneReloader(const std::filesystem::path& file);

  /// Call when the first load has succeeded.
  /// in   files  LoadedScene::files
  void was_read(std::span<const std::filesystem::path> files);

  /// Checks the files when it is time, and begins a reload if they have changed. Call it in every frame.
  /// in   now_s      time of a monotonic clock
  ///      make_read  returns the reload job to run
  void look(double now_s, const std::function<BackgroundReload::Read()>& make_read);

  /// Returns a finished reload once. After a success its files are watched; after a failure the old files stay watched.
  std::optional<ReloadResult> take();

 private:
  FileStamps stamps() const;
  void fail();

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> files_;
  bool failed_ = false;                      ///< the last reload failed, so the folder is watched, too
  std::set<std::filesystem::path> ignored_;  ///< files that were in the folder at the first failure
  FileWatch watch_;
  FileStamps before_;  ///< stamps before the running reload, of the watched files and the folder
  BackgroundReload read_;
};

}  // namespace sinew::viewer
