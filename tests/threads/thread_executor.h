// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "runtime/threads/job_thread.h"

namespace sinew::test {

/// A small job system of an engine: a fixed set of threads and the caller take indices one by one.
class ThreadPool {
 public:
  explicit ThreadPool(std::size_t thread_count) {
    for (std::size_t i = 1; i < thread_count; ++i) threads_.emplace_back([this] { serve(); });
  }
  ~ThreadPool() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  void run(std::size_t count, const std::function<void(std::size_t)>& body) {
    {
      const std::lock_guard lock(mutex_);
      body_ = &body;
      count_ = count;
      next_ = 0;
      helpers_ = threads_.size();
      ++round_;
    }
    changed_.notify_all();
    take_all();
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return helpers_ == 0; });
  }

  Executor executor() {
    return [this](std::size_t count, const std::function<void(std::size_t)>& body) { run(count, body); };
  }

 private:
  void take_all() {
    for (std::size_t i = next_++; i < count_; i = next_++) (*body_)(i);
  }
  void serve() {
    std::unique_lock lock(mutex_);
    for (std::uint64_t seen = 0;;) {
      changed_.wait(lock, [&] { return stop_ || round_ != seen; });
      if (stop_) return;
      seen = round_;
      lock.unlock();
      take_all();
      lock.lock();
      if (--helpers_ == 0) changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::thread> threads_;
  const std::function<void(std::size_t)>* body_ = nullptr;
  std::size_t count_ = 0, helpers_ = 0;
  std::atomic<std::size_t> next_{0};
  std::uint64_t round_ = 0;
  bool stop_ = false;
};

}  // namespace sinew::test
