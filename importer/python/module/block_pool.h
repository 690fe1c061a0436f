// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

namespace sinew::python {

/// Memory of arrays, kept for later arrays of about the same size. Touching fresh pages takes three times as long as
/// sampling the poses that are written to them.
class BlockPool {
 public:
  static constexpr std::size_t kMostKept_bytes = std::size_t{64} << 20;

  struct Block {
    void* memory = nullptr;
    std::size_t bytes = 0;
  };

  /// One pool for the process. It is never destroyed, since arrays may outlive everything else.
  static BlockPool& shared() {
    static BlockPool* const pool = new BlockPool;
    return *pool;
  }

  /// A block of at least `bytes`, at most twice as large.
  /// err  std::bad_alloc
  Block take(std::size_t bytes) {
    {
      const std::lock_guard lock(mutex_);
      for (Block& kept : kept_) {
        if (kept.bytes < bytes || kept.bytes / 2 > bytes) continue;
        kept_bytes_ -= kept.bytes;
        const Block found = std::exchange(kept, kept_.back());
        kept_.pop_back();
        return found;
      }
    }
    const std::size_t rounded = (bytes + 63) / 64 * 64 + 64;
    void* const memory = std::aligned_alloc(64, rounded);
    if (memory == nullptr) throw std::bad_alloc();
    return {memory, rounded};
  }

  /// Keeps a block for a later take(), or frees it where enough is kept.
  void give_back(const Block& block) noexcept {
    const std::lock_guard lock(mutex_);
    if (kept_.size() < kept_.capacity() && kept_bytes_ + block.bytes <= kMostKept_bytes) {
      kept_.push_back(block);
      kept_bytes_ += block.bytes;
    } else {
      std::free(block.memory);
    }
  }

 private:
  BlockPool() { kept_.reserve(64); }

  std::mutex mutex_;
  std::vector<Block> kept_;
  std::size_t kept_bytes_ = 0;
};

}  // namespace sinew::python
