// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace sinew::tool {

/// An output that is written piece by piece. A name that ends in .gz is compressed. A file is written beside its place
/// and takes it in finish(), so it appears complete or not at all. A symbolic link stays; its file is replaced. A
/// stream (output.h) gets the bytes at once. One output is written with write() or with write_at(), not with both.
class StreamedFile {
 public:
  explicit StreamedFile(const std::string& file_or_empty);  ///< empty = stdout
  ~StreamedFile();
  StreamedFile(const StreamedFile&) = delete;
  StreamedFile& operator=(const StreamedFile&) = delete;

  /// False if the output could not be opened; errno says why.
  bool opened() const noexcept { return file_ != nullptr; }

  /// Writes the next bytes. After a failure nothing more is written, and finish() returns false.
  void write(std::string_view bytes);

  /// Writes at a place of the file, in any order; gaps are filled with zeros. For a stream or a .gz file the bytes wait
  /// in a temporary file for finish().
  void write_at(std::uint64_t place, std::string_view bytes);

  /// False if something could not be written; errno has the first reason.
  bool finish();

 private:
  void copy_placed();
  void note(bool failed);

  std::filesystem::path target_, unfinished_;  // Empty for a stream.
  void* file_ = nullptr;                       // gzFile
  int placed_ = -1;                            // descriptor that write_at() writes to: the file itself, or waiting_
  int waiting_ = -1;                           // descriptor of a temporary file
  bool failed_ = false;
  int reason_ = 0;  ///< errno of the first failure
};

}  // namespace sinew::tool
