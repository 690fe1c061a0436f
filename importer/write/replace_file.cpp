// SPDX-License-Identifier: MIT
#include "importer/write/replace_file.h"

#include <cerrno>
#include <cstring>
#include <deque>
#include <vector>

#include "importer/platform/files.h"

namespace sinew::write {
namespace fs = std::filesystem;
namespace {

/// A temporary file next to `target`; the destructor removes it unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target)
      : path_(platform::temporary_beside(target)), descriptor_(platform::create_new(path_)) {}
  ~TemporaryFile() {
    if (descriptor_ < 0) return;
    close();
    if (!renamed_) platform::remove(path_);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  bool opened() const noexcept { return descriptor_ >= 0; }

  bool write(std::span<const std::byte> bytes) const {
    return platform::write_all(descriptor_, bytes) && platform::flush_to_disk(descriptor_);
  }

  /// Renames the file. It is closed first, because Windows renames no open file.
  bool rename_to(const fs::path& target) {
    close();
    renamed_ = platform::rename_over(path_, target);
    return renamed_;
  }

 private:
  void close() {
    if (!closed_) platform::close(descriptor_);
    closed_ = true;
  }

  fs::path path_;
  int descriptor_ = -1;
  bool renamed_ = false, closed_ = false;
};

/// The file to replace: the target of a symbolic link, else the file itself.
fs::path target_of(const fs::path& file, std::string& fault) {
  std::error_code error;
  if (!fs::exists(file, error)) return file;
  if (!fs::is_regular_file(file, error)) fault = "exists and is not a regular file";
  const fs::path target = fs::canonical(file, error);
  if (fault.empty() && error) fault = error.message();
  return target;
}

}  // namespace

std::optional<std::string> replace_files(std::span<const FileContent> files) {
  std::vector<fs::path> targets;
  std::deque<TemporaryFile> written;
  for (const FileContent& content : files) {
    std::string fault;
    targets.push_back(target_of(content.file, fault));
    if (!fault.empty()) return fault;
    const TemporaryFile& temporary = written.emplace_back(targets.back());
    if (!temporary.opened()) return "no file can be made in its folder: " + std::string(std::strerror(errno));
    if (!temporary.write(content.bytes)) return std::strerror(errno);
  }
  for (std::size_t i = 0; i < written.size(); ++i)
    if (!written[i].rename_to(targets[i])) return std::strerror(errno);
  return std::nullopt;
}

std::optional<std::string> replace_file(const fs::path& file, std::span<const std::byte> bytes) {
  const FileContent content{file, bytes};
  return replace_files({&content, 1});
}

}  // namespace sinew::write
