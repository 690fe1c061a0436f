// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "importer/tool/files/streamed_file.h"
#include "importer/tool/poses/npy.h"

namespace sinew::tool {

/// An .npz file: a zip of uncompressed .npy files. All arrays are written side by side: their shapes are known before
/// the first number, so each array has its place in the file. From 4 GiB on, the fields of ZIP64 are used.
///
/// cost  holds at most kHeld bytes of numbers, and the names
class NpzFile {
 public:
  static constexpr std::size_t kHeld = std::size_t{1} << 22;

  /// in   out  must outlive this
  explicit NpzFile(StreamedFile& out) : out_(out) {}

  /// Gives an array the next place in the file.
  /// out   its number
  std::size_t add(const NpyArray& array);

  /// Appends numbers to an array. CONTRACT: no array gets more bytes than its shape holds.
  void append(std::size_t array, std::string_view bytes);

  /// Writes the buffered numbers and the zip directory. CONTRACT: every array is full.
  void finish();

 private:
  struct Entry {
    std::string name;
    std::uint64_t at = 0, size = 0;       // place of the header in the zip; bytes of the .npy file
    std::uint64_t data_at = 0, done = 0;  // place of the .npy file in the zip; bytes of it that are written
    std::uint32_t checksum = 0;
    std::string held;
  };
  void flush(Entry& entry);
  void flush_all();

  StreamedFile& out_;
  std::vector<Entry> entries_;
  std::uint64_t end_ = 0;  // end of the last entry
  std::size_t held_ = 0;
};

}  // namespace sinew::tool
