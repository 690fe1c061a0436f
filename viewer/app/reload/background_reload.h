// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "viewer/app/loaded_scene.h"

namespace sinew::viewer {

/// Result of a reload, and the messages that it printed.
struct ReloadResult {
  tl::expected<LoadedScene, LoadError> loaded;
  std::vector<std::string> messages;
};

/// Loads a scene on another thread.
class BackgroundReload {
 public:
  /// in   log_line  receives each warning as one line
  using Read =
      std::function<tl::expected<LoadedScene, LoadError>(const std::function<void(const std::string&)>& log_line)>;

  /// Begins a reload; `read` must own all data that it uses. Precondition: no other reload is running.
  void begin(Read read);

  bool running() const noexcept { return result_.valid(); }

  /// Returns the result once, when it is ready; else nothing. Running out of memory is reported as a LoadError.
  std::optional<ReloadResult> take();

 private:
  std::future<ReloadResult> result_;  ///< from std::async, so its destructor waits for the thread
};

}  // namespace sinew::viewer
