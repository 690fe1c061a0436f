// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/reload/file_stamps.h"

namespace sinew::viewer {

/// Decides when changed files are read again. It has neither a clock nor a disk: both are given.
///
/// Files count as changed when they differ from what was read. They are read when two looks in a row see the same, so
/// a file that is being written waits until its writer pauses. A read that came too early is repaired by the next
/// change, and a change back to what was read needs no read at all.
class FileWatch {
 public:
  static constexpr double kPeriod_s = 0.25;  ///< between two looks

  /// It is time to look.
  /// in   now_s  of any clock that never goes back
  bool due(double now_s) const noexcept { return now_s >= next_look_s_; }

  /// in   seen  the files as they are now
  /// out  true: read them now
  bool look(double now_s, FileStamps seen);

  /// in   files  as they were before the read began, so that a change during the read is a change
  void was_read(FileStamps files);

 private:
  FileStamps read_, seen_;
  double next_look_s_ = 0.0;
};

}  // namespace sinew::viewer
