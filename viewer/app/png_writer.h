// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "viewer/app/headless.h"

namespace sinew::viewer {

/// Writes pictures as PNG files on its own thread, because encoding takes longer than drawing. The queue holds four
/// pictures; `write` blocks while it is full.
class PngWriter {
 public:
  PngWriter();
  ~PngWriter();                                             ///< waits until all pictures are written
  void write(std::filesystem::path file, Picture picture);  ///< alpha is written unchanged
  std::vector<std::string> finish();  ///< waits; lists the files that could not be written, and why

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
