// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/reload/file_stamps.h"

namespace sinew::viewer {

/// Decides when changed files are reloaded. It uses no clock and no disk: times and stamps are passed in.
///
/// Files count as changed when their stamps differ from those of the last load. They are reloaded once two checks in a
/// row see equal stamps, so a file is not read while it is being written. A reload that came too early is followed by
/// another one after the next change.
class FileWatch {
 public:
  static constexpr double kPeriod_s = 0.25;  ///< time between two checks

  /// True if it is time for the next check.
  /// in   now_s  time of any monotonic clock
  bool due(double now_s) const noexcept { return now_s >= next_look_s_; }

  /// in   seen  current stamps of the files
  /// out  true = reload them now
  bool look(double now_s, FileStamps seen);

  /// in   files  stamps taken before the load began, so that a change during loading is noticed
  void was_read(FileStamps files);

 private:
  FileStamps read_, seen_;
  double next_look_s_ = 0.0;
};

}  // namespace sinew::viewer
