// SPDX-License-Identifier: MIT
#include "viewer/app/reload/file_watch.h"

#include <utility>

namespace sinew::viewer {

bool FileWatch::look(double now_s, FileStamps seen) {
  next_look_s_ = now_s + kPeriod_s;
  const bool still = seen == seen_, changed = seen != read_;
  seen_ = std::move(seen);
  return still && changed;
}

void FileWatch::was_read(FileStamps files) {
  seen_ = files;
  read_ = std::move(files);
}

}  // namespace sinew::viewer
