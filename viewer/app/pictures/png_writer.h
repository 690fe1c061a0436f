// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "viewer/app/headless.h"

namespace sinew::viewer {

/// Encodes and writes PNG files on its own thread, because encoding takes longer than drawing.
class PngWriter {
 public:
  PngWriter();
  ~PngWriter();  ///< waits until all pictures are written
  /// Queues a picture; blocks while four are waiting. Alpha is written unchanged.
  void write(std::filesystem::path file, Picture picture);
  std::vector<std::string> finish();  ///< waits for all writes; returns the files that failed, with the reason

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
