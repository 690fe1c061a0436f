// SPDX-License-Identifier: MIT
#include "viewer/app/cache/cache_reader.h"

#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace sinew::viewer {

CacheReader::CacheReader(const CacheFile& file, Reads reads, std::size_t most_reads) : file_(file), asked_(most_reads) {
  if (!file.path.empty()) descriptor_ = ::open(file.path.c_str(), O_RDONLY | O_CLOEXEC);
  if (reads == Reads::beside) thread_ = std::thread([this] { work(); });
}

CacheReader::~CacheReader() {
  stop();
  if (descriptor_ >= 0) ::close(descriptor_);
}

FrameReader CacheReader::reader() noexcept {
  const auto read = [](void* context, std::uint64_t offset, std::span<std::byte> into, FrameRead& frame) noexcept {
    return static_cast<CacheReader*>(context)->ask({offset, into, &frame});
  };
  return {read, this};
}

ReadOutcome CacheReader::ask(const Asked& asked) noexcept {
  if (!thread_.joinable()) return !ends_ && read(asked) ? ReadOutcome::done : ReadOutcome::failed;
  {
    const std::scoped_lock lock(mutex_);
    if (count_ == asked_.size()) return ReadOutcome::failed;
    asked_[(first_ + count_++) % asked_.size()] = asked;
  }
  came_.notify_one();
  return ReadOutcome::pending;
}

bool CacheReader::read(const Asked& asked) noexcept {
  if (file_.path.empty()) {
    if (asked.offset > file_.bytes.size() || asked.into.size() > file_.bytes.size() - asked.offset) return false;
    std::memcpy(asked.into.data(), file_.bytes.data() + asked.offset, asked.into.size());
    bytes_read_.fetch_add(asked.into.size(), std::memory_order_relaxed);
    return true;
  }
  for (std::size_t done = 0; done < asked.into.size();) {
    const auto rest = asked.into.subspan(done);
    const auto bytes = ::pread(descriptor_, rest.data(), rest.size(), static_cast<off_t>(asked.offset + done));
    if (bytes <= 0) return false;  // also where the file has become shorter
    done += static_cast<std::size_t>(bytes);
    bytes_read_.fetch_add(static_cast<std::uint64_t>(bytes), std::memory_order_relaxed);
  }
  return true;
}

void CacheReader::work() noexcept {
  std::unique_lock lock(mutex_);
  for (;;) {
    came_.wait(lock, [this] { return count_ > 0 || ends_; });
    if (count_ == 0) return;
    const Asked next = asked_[first_];
    first_ = (first_ + 1) % asked_.size();
    --count_;
    lock.unlock();
    next.read->finish(read(next));
    lock.lock();
  }
}

void CacheReader::stop() noexcept {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  came_.notify_one();
  if (thread_.joinable()) thread_.join();
}

}  // namespace sinew::viewer
