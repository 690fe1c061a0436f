// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "viewer/app/headless.h"

namespace sinew::viewer {

/// True if the name ends in .mp4, .webm or .gif.
bool names_film(const std::string& file);

/// The arguments that make ffmpeg write a film of raw pictures from its standard input. One thread and no metadata, so
/// that the bytes are the same in every run.
std::vector<std::string> ffmpeg_arguments(const std::string& file, std::uint32_t width, std::uint32_t height,
                                          double fps);

/// Writes a film with the program ffmpeg, which gets each picture through a pipe. The file appears when it is complete.
class FilmWriter {
 public:
  FilmWriter(std::string file, double fps);
  ~FilmWriter();
  FilmWriter(const FilmWriter&) = delete;
  FilmWriter& operator=(const FilmWriter&) = delete;

  /// Adds a picture. All pictures must have the size of the first. After an error it does nothing.
  void write(const Picture& picture);

  /// Ends the film.
  /// out  one sentence that says why there is no film; empty = there is
  std::string finish();

 private:
  void start(const Picture& first);
  int wait();

  std::string file_, part_;  ///< `part_` is the file until it is complete
  double fps_;
  int pipe_ = -1;
  int process_ = -1;
  std::string error_;
};

}  // namespace sinew::viewer
