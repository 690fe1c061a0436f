// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "viewer/app/exhibit.h"

namespace sinew::viewer {

/// What a read gave, and what it said about the file.
struct ReadExhibit {
  tl::expected<Exhibit, LoadError> exhibit;
  std::vector<std::string> said;
};

/// Reads an exhibit on a thread of its own.
class BackgroundRead {
 public:
  /// in   say  receives each warning as one line
  using Read = std::function<tl::expected<Exhibit, LoadError>(const std::function<void(const std::string&)>& say)>;

  /// Begins a read, which takes its data along. Breaks a contract while another one runs.
  void begin(Read read);

  bool running() const noexcept { return result_.valid(); }

  /// The result, once, as soon as it is there. Memory that runs out is a LoadError.
  std::optional<ReadExhibit> take();

 private:
  std::future<ReadExhibit> result_;  ///< of std::async: its end waits for the thread
};

}  // namespace sinew::viewer
