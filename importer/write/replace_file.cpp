// SPDX-License-Identifier: MIT
#include "importer/write/replace_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace sinew::write {
namespace fs = std::filesystem;
namespace {

/// A new file next to `target`. The destructor removes it unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target)
      : path_(target.string() + "." + std::to_string(::getpid()) + ".tmp"),
        descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {}
  ~TemporaryFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    if (!renamed_) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  bool opened() const noexcept { return descriptor_ >= 0; }

  bool write(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return ::fsync(descriptor_) == 0;
  }

  bool rename_to(const fs::path& target) {
    renamed_ = ::rename(path_.c_str(), target.c_str()) == 0;
    return renamed_;
  }

 private:
  std::string path_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

}  // namespace

std::optional<std::string> replace_file(const fs::path& file, std::span<const std::byte> bytes) {
  std::error_code error;
  const bool exists = fs::exists(file, error);
  if (exists && !fs::is_regular_file(file, error)) return "exists and is not a regular file";
  const fs::path target = exists ? fs::canonical(file, error) : file;
  if (error) return error.message();
  TemporaryFile temporary(target);
  if (temporary.opened() && temporary.write(bytes) && temporary.rename_to(target)) return std::nullopt;
  return std::strerror(errno);
}

}  // namespace sinew::write
