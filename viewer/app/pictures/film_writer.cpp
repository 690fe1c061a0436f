// SPDX-License-Identifier: MIT
#include "viewer/app/pictures/film_writer.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "viewer/app/open/file_names.h"

extern char** environ;

namespace sinew::viewer {
namespace {

constexpr const char* kEvenSides = "pad=ceil(iw/2)*2:ceil(ih/2)*2";  // 4:2:0 has no odd sides

std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.9g", number);
  return text;
}

}  // namespace

bool names_film(const std::string& file) {
  const std::string ending = ending_of(file);
  return ending == ".mp4" || ending == ".webm" || ending == ".gif";
}

std::vector<std::string> ffmpeg_arguments(const std::string& file, std::uint32_t width, std::uint32_t height,
                                          double fps) {
  std::vector<std::string> arguments{
      "ffmpeg",   "-v",         "error", "-y", "-f",
      "rawvideo", "-pix_fmt",   "rgba",  "-s", std::to_string(width) + "x" + std::to_string(height),
      "-r",       text_of(fps), "-i",    "-"};
  const auto add = [&](std::initializer_list<const char*> more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
  };
  const std::string ending = ending_of(file);
  if (ending == ".gif")
    add({"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse"});
  else if (ending == ".webm")
    add({"-vf", kEvenSides, "-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-crf", "24", "-b:v", "0"});
  else
    add({"-vf", kEvenSides, "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18", "-movflags", "+faststart"});
  add({"-threads", "1", "-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact"});
  arguments.push_back("file:" + file);  // a name with a colon is no protocol
  return arguments;
}

FilmWriter::FilmWriter(std::string file, double fps) : file_(std::move(file)), fps_(fps) {
  std::signal(SIGPIPE, SIG_IGN);  // an ffmpeg that ends early is an error of write()
  const std::filesystem::path path(file_);
  part_ = (path.parent_path() / (path.stem().string() + ".part" + path.extension().string())).string();
}

FilmWriter::~FilmWriter() {
  if (process_ > 0) (void)finish();
}

void FilmWriter::start(const Picture& first) {
  std::vector<std::string> arguments = ffmpeg_arguments(part_, first.width, first.height, fps_);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    error_ = file_ + ": no pipe to ffmpeg: " + std::strerror(errno);
    return;
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  const int failed = ::posix_spawnp(&process_, "ffmpeg", &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[0]);
  if (failed != 0) {
    ::close(ends[1]);
    process_ = -1;
    error_ = file_ + ": films need the program ffmpeg (Debian: ffmpeg): " + std::strerror(failed);
    return;
  }
  pipe_ = ends[1];
}

void FilmWriter::write(const Picture& picture) {
  if (error_.empty() && process_ < 0) start(picture);
  std::span<const std::uint8_t> left(picture.rgba);
  while (error_.empty() && !left.empty()) {
    const ssize_t written = ::write(pipe_, left.data(), left.size());
    if (written > 0)
      left = left.subspan(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      error_ = file_ + ": ffmpeg takes no more pictures: " + std::strerror(errno);
  }
}

int FilmWriter::wait() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

std::string FilmWriter::finish() {
  if (pipe_ >= 0) ::close(std::exchange(pipe_, -1));
  if (process_ > 0 && wait() != 0 && error_.empty()) error_ = file_ + ": ffmpeg has failed";
  std::error_code failed;
  if (error_.empty())
    std::filesystem::rename(part_, file_, failed);
  else
    std::filesystem::remove(part_, failed);
  if (error_.empty() && failed) error_ = file_ + ": " + failed.message();
  return error_;
}

}  // namespace sinew::viewer
