// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "viewer/app/reload/background_read.h"
#include "viewer/app/reload/file_watch.h"

namespace sinew::viewer {

/// Watches the files of an exhibit and reads it again when they change.
///
/// After a failed read, files that come into the folder count, too: a failed read does not say which file it lacked.
/// Those that are there already do not, since the program's own log may be among them.
class ExhibitWatch {
 public:
  /// Made before the exhibit is read for the first time: a change during that read is seen, too.
  explicit ExhibitWatch(const std::filesystem::path& file);

  /// The first read is done.
  /// in   files  of the exhibit: Exhibit::files
  void was_read(std::span<const std::filesystem::path> files);

  /// Looks at the files when it is time, and begins to read them where they have changed. Called in every frame.
  /// in   now_s      of a clock that never goes back
  ///      make_read  gives the read that begins now
  void look(double now_s, const std::function<BackgroundRead::Read()>& make_read);

  /// What was read again, once. Its files are watched from now on; a failed read leaves the watched files as they were.
  std::optional<ReadExhibit> take();

 private:
  FileStamps stamps() const;
  void fail();

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> files_;
  bool failed_ = false;                      ///< the last read: the folder counts, too
  std::set<std::filesystem::path> ignored_;  ///< files of the folder that were there when it failed first
  FileWatch watch_;
  FileStamps before_;  ///< the read that runs: of the watched files and of the folder
  BackgroundRead read_;
};

}  // namespace sinew::viewer
