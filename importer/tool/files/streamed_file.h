// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace sinew::tool {

/// A file that is written piece by piece, or stdout. A name that ends in .gz is compressed. The file is written beside
/// its place and takes it in finish(), so that it appears complete or not at all; behind a symbolic link the file that
/// it names is replaced.
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

  /// False: something could not be written; errno has the reason of the last step.
  bool finish();

 private:
  std::filesystem::path target_, unfinished_;  // empty for stdout
  void* file_ = nullptr;                       // gzFile
  bool failed_ = false;
};

}  // namespace sinew::tool
