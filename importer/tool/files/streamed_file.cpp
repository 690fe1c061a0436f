// SPDX-License-Identifier: MIT
#include "importer/tool/files/streamed_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <span>
#include <system_error>
#include <utility>

#include "importer/platform/files.h"
#include "importer/platform/program.h"
#include "importer/tool/files/output.h"

namespace sinew::tool {

StreamedFile::StreamedFile(const std::string& file_or_empty) {
  if (file_or_empty.empty()) {
    file_ = gzdopen(platform::duplicate(platform::kStandardOutput), "wbT");
    return;
  }
  const bool compressed = file_or_empty.ends_with(".gz");
  const std::filesystem::path path = platform::path_of(file_or_empty);
  if (is_stream(path)) {
    const int stream = platform::open_to_write(path);
    if (stream >= 0) file_ = gzdopen(stream, compressed ? "wb6" : "wbT");
    return;
  }
  std::error_code error;
  target_ = std::filesystem::canonical(path, error);
  if (error) target_ = path;  // a new file
  unfinished_ = platform::temporary_beside(target_);
  const int file = platform::create_new(unfinished_);
  if (file < 0) return;
  file_ = gzdopen(file, compressed ? "wb6" : "wbT");
  if (!compressed) placed_ = file;
}

StreamedFile::~StreamedFile() {
  if (waiting_ >= 0) platform::close(waiting_);
  if (file_ == nullptr) return;
  gzclose(static_cast<gzFile>(file_));
  if (!unfinished_.empty()) platform::remove(unfinished_);
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
    placed_ = waiting_ = platform::open_temporary();
    note(waiting_ < 0);
  }
  if (failed_) return;
  note(!platform::seek(placed_, place) || !platform::write_all(placed_, std::as_bytes(std::span(bytes))));
}

/// Writes the waiting bytes of the temporary file.
void StreamedFile::copy_placed() {
  std::array<char, std::size_t{1} << 16> block;
  note(!platform::seek(waiting_, 0));
  while (!failed_) {
    const auto count = platform::read_some(waiting_, std::as_writable_bytes(std::span(block)));
    note(!count);
    if (!count || *count == 0) break;
    write({block.data(), *count});
  }
}

void StreamedFile::note(bool failed) {
  if (failed && !std::exchange(failed_, true)) reason_ = errno;
}

bool StreamedFile::finish() {
  if (waiting_ >= 0) copy_placed();
  note(gzclose(static_cast<gzFile>(std::exchange(file_, nullptr))) != Z_OK);
  if (!unfinished_.empty()) {
    note(!failed_ && !platform::rename_over(unfinished_, target_));
    if (failed_) platform::remove(unfinished_);
  }
  errno = reason_;
  return !failed_;
}

}  // namespace sinew::tool
