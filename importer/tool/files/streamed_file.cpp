// SPDX-License-Identifier: MIT
#include "importer/tool/files/streamed_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "importer/tool/files/output.h"

namespace sinew::tool {

StreamedFile::StreamedFile(const std::string& file_or_empty) {
  if (file_or_empty.empty()) {
    file_ = gzdopen(dup(STDOUT_FILENO), "wbT");
    return;
  }
  const bool compressed = file_or_empty.ends_with(".gz");
  if (is_stream(file_or_empty)) {
    const int stream = open(file_or_empty.c_str(), O_WRONLY | O_CLOEXEC);
    if (stream >= 0) file_ = gzdopen(stream, compressed ? "wb6" : "wbT");
    return;
  }
  std::error_code error;
  target_ = std::filesystem::canonical(file_or_empty, error);
  if (error) target_ = file_or_empty;  // a new file
  unfinished_ = target_.string() + "." + std::to_string(getpid()) + ".tmp";
  const int file = open(unfinished_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return;
  file_ = gzdopen(file, compressed ? "wb6" : "wbT");
  if (!compressed) placed_ = file;
}

StreamedFile::~StreamedFile() {
  if (waiting_ != nullptr) std::fclose(waiting_);
  if (file_ == nullptr) return;
  gzclose(static_cast<gzFile>(file_));
  if (!unfinished_.empty()) unlink(unfinished_.c_str());
}

void StreamedFile::write(std::string_view bytes) {
  constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;  // zlib counts in int
  while (!failed_ && !bytes.empty()) {
    const std::size_t count = std::min(bytes.size(), kMostAtOnce);
    note(gzwrite(static_cast<gzFile>(file_), bytes.data(), static_cast<unsigned>(count)) <= 0);
    bytes.remove_prefix(count);
  }
}

void StreamedFile::write_at(std::uint64_t place, std::string_view bytes) {
  if (placed_ < 0) {
    waiting_ = std::tmpfile();
    note(waiting_ == nullptr);
    placed_ = failed_ ? -1 : fileno(waiting_);
  }
  while (!failed_ && !bytes.empty()) {
    const ssize_t count = pwrite(placed_, bytes.data(), bytes.size(), static_cast<off_t>(place));
    note(count <= 0);
    if (failed_) return;
    place += static_cast<std::uint64_t>(count);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

/// Writes what waits.
void StreamedFile::copy_placed() {
  std::array<char, std::size_t{1} << 16> block;
  std::rewind(waiting_);
  while (!failed_) {
    const std::size_t count = std::fread(block.data(), 1, block.size(), waiting_);
    if (count == 0) break;
    write({block.data(), count});
  }
  note(std::ferror(waiting_) != 0);
}

void StreamedFile::note(bool failed) {
  if (failed && !std::exchange(failed_, true)) reason_ = errno;
}

bool StreamedFile::finish() {
  if (waiting_ != nullptr) copy_placed();
  note(gzclose(static_cast<gzFile>(std::exchange(file_, nullptr))) != Z_OK);
  if (!unfinished_.empty()) {
    note(!failed_ && rename(unfinished_.c_str(), target_.c_str()) != 0);
    if (failed_) unlink(unfinished_.c_str());
  }
  errno = reason_;
  return !failed_;
}

}  // namespace sinew::tool
