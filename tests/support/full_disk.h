// SPDX-License-Identifier: MIT
#pragma once
#include <sys/resource.h>

#include <csignal>
#include <cstdio>

namespace sinew::test {

/// Simulates a full disk: while this object lives, no file can grow beyond `most_bytes`.
class FullDisk {
 public:
  explicit FullDisk(rlim_t most_bytes) {
    std::fflush(nullptr);  // flush now: bytes that were buffered earlier must not meet the limit
    before_signal_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{most_bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, before_signal_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*before_signal_)(int) = SIG_DFL;
};

}  // namespace sinew::test
