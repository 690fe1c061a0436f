// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace sinew::tool {

/// A file that is written piece by piece, or stdout. A name that ends in .gz is compressed. The file is written beside
/// its place and takes it in finish(), so that it appears complete or not at all; behind a symbolic link the file that
/// it names is replaced. One file is written with write() or with write_at(), not with both.
class StreamedFile {
 public:
  explicit StreamedFile(const std::string& file_or_empty);  ///< empty = stdout
  ~StreamedFile();
  StreamedFile(const StreamedFile&) = delete;
  StreamedFile& operator=(const StreamedFile&) = delete;

  /// False: errno says why.
  bool opened() const noexcept { return file_ != nullptr; }

  /// After a failure nothing more is written, and finish() tells.
  void write(std::string_view bytes);

  /// Writes at a place of the file, in any order; what is left out in between is zero. Where an output is written in
  /// one go (stdout, .gz), the bytes wait in a temporary file for finish().
  void write_at(std::uint64_t place, std::string_view bytes);

  /// False: something could not be written; errno has the reason of the last step.
  bool finish();

 private:
  void copy_placed();

  std::filesystem::path target_, unfinished_;  // empty for stdout
  void* file_ = nullptr;                       // gzFile
  int placed_ = -1;                            // where write_at() writes: the file itself, or the one of waiting_
  std::FILE* waiting_ = nullptr;
  bool failed_ = false;
};

}  // namespace sinew::tool
