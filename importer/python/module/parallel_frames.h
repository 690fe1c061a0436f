// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace sinew::python {

/// Calls work(first, last) for consecutive parts of [0, frames), one part a thread, and rethrows the first exception.
template <class Work>
void parallel_frames(std::size_t frames, std::size_t threads, const Work& work) {
  const std::size_t parts = std::max<std::size_t>(1, std::min(threads, frames));
  std::vector<std::exception_ptr> failed(parts);
  const auto run = [&](std::size_t part) {
    try {
      work(frames * part / parts, frames * (part + 1) / parts);
    } catch (...) {
      failed[part] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> running;
    for (std::size_t part = 1; part < parts; ++part) running.emplace_back(run, part);
    run(0);
  }
  for (const std::exception_ptr& error : failed)
    if (error) std::rethrow_exception(error);
}

}  // namespace sinew::python
