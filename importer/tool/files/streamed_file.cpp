// SPDX-License-Identifier: MIT
#include "importer/tool/files/streamed_file.h"

#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <system_error>
#include <utility>

namespace sinew::tool {

StreamedFile::StreamedFile(const std::string& file_or_empty) {
  if (file_or_empty.empty()) {
    file_ = gzdopen(dup(STDOUT_FILENO), "wbT");
    return;
  }
  std::error_code error;
  target_ = std::filesystem::canonical(file_or_empty, error);
  if (error) target_ = file_or_empty;  // a new file
  unfinished_ = target_.string() + "." + std::to_string(getpid()) + ".tmp";
  file_ = gzopen(unfinished_.c_str(), file_or_empty.ends_with(".gz") ? "wbx6" : "wbxT");
}

StreamedFile::~StreamedFile() {
  if (file_ == nullptr) return;
  gzclose(static_cast<gzFile>(file_));
  if (!unfinished_.empty()) unlink(unfinished_.c_str());
}

void StreamedFile::write(std::string_view bytes) {
  constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;  // zlib counts in int
  while (!failed_ && !bytes.empty()) {
    const std::size_t count = std::min(bytes.size(), kMostAtOnce);
    failed_ = gzwrite(static_cast<gzFile>(file_), bytes.data(), static_cast<unsigned>(count)) <= 0;
    bytes.remove_prefix(count);
  }
}

bool StreamedFile::finish() {
  const int closed = gzclose(static_cast<gzFile>(std::exchange(file_, nullptr)));
  const bool written = closed == Z_OK && !failed_;
  if (unfinished_.empty()) return written;
  if (written && rename(unfinished_.c_str(), target_.c_str()) == 0) return true;
  unlink(unfinished_.c_str());
  return false;
}

}  // namespace sinew::tool
