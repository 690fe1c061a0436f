// SPDX-License-Identifier: MIT
#include "viewer/app/cache/cache_reader.h"

#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace sinew::viewer {

CacheReader::CacheReader(const CacheFile& file, Reads reads, std::size_t most_reads)
    : file_(file), requests_(most_reads) {
  if (!file.path.empty()) descriptor_ = ::open(file.path.c_str(), O_RDONLY | O_CLOEXEC);
  if (reads == Reads::on_thread) thread_ = std::thread([this] { work(); });
}

CacheReader::~CacheReader() {
  stop();
  if (descriptor_ >= 0) ::close(descriptor_);
}

FrameReader CacheReader::reader() noexcept {
  const auto read = [](void* context, std::uint64_t offset, std::span<std::byte> into, FrameRead& frame) noexcept {
    return static_cast<CacheReader*>(context)->submit({offset, into, &frame});
  };
  return {read, this};
}

ReadOutcome CacheReader::submit(const Request& request) noexcept {
  if (!thread_.joinable()) return !stopping_ && read(request) ? ReadOutcome::done : ReadOutcome::failed;
  {
    const std::scoped_lock lock(mutex_);
    if (count_ == requests_.size()) return ReadOutcome::failed;
    requests_[(first_ + count_++) % requests_.size()] = request;
  }
  arrived_.notify_one();
  return ReadOutcome::pending;
}

bool CacheReader::read(const Request& request) noexcept {
  if (file_.path.empty()) {
    if (request.offset > file_.bytes.size() || request.into.size() > file_.bytes.size() - request.offset) return false;
    std::memcpy(request.into.data(), file_.bytes.data() + request.offset, request.into.size());
    bytes_read_.fetch_add(request.into.size(), std::memory_order_relaxed);
    return true;
  }
  for (std::size_t done = 0; done < request.into.size();) {
    const auto rest = request.into.subspan(done);
    const auto bytes = ::pread(descriptor_, rest.data(), rest.size(), static_cast<off_t>(request.offset + done));
    if (bytes <= 0) return false;  // 0 = end of file: the file has become shorter
    done += static_cast<std::size_t>(bytes);
    bytes_read_.fetch_add(static_cast<std::uint64_t>(bytes), std::memory_order_relaxed);
  }
  return true;
}

void CacheReader::work() noexcept {
  std::unique_lock lock(mutex_);
  for (;;) {
    arrived_.wait(lock, [this] { return count_ > 0 || stopping_; });
    if (count_ == 0) return;
    const Request next = requests_[first_];
    first_ = (first_ + 1) % requests_.size();
    --count_;
    lock.unlock();
    next.read->finish(read(next));
    lock.lock();
  }
}

void CacheReader::stop() noexcept {
  {
    const std::scoped_lock lock(mutex_);
    stopping_ = true;
  }
  arrived_.notify_one();
  if (thread_.joinable()) thread_.join();
}

}  // namespace sinew::viewer
