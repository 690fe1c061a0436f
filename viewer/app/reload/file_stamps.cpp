// SPDX-License-Identifier: MIT
#include "viewer/app/reload/file_stamps.h"

#include <system_error>

namespace sinew::viewer {
namespace fs = std::filesystem;
namespace {

// Ignores errors: a file may disappear at any time.
void add_stamp(const fs::path& file, FileStamps& stamps) {
  std::error_code fault;
  if (!fs::is_regular_file(file, fault)) return;
  FileStamp stamp;
  stamp.written = fs::last_write_time(file, fault);
  if (fault) return;
  stamp.bytes = fs::file_size(file, fault);
  if (!fault) stamps.emplace(file, stamp);
}

}  // namespace

fs::path stamp_key(const fs::path& file) {
  std::error_code fault;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const fs::path real = fs::canonical(folder, fault);
  return fault ? file : real / file.filename();
}

FileStamps stamps_of(std::span<const fs::path> files) {
  FileStamps stamps;
  for (const fs::path& file : files) add_stamp(file, stamps);
  return stamps;
}

void add_stamps_in(const fs::path& folder, FileStamps& stamps) {
  std::error_code fault;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault))
    add_stamp(entry->path(), stamps);
}

}  // namespace sinew::viewer
