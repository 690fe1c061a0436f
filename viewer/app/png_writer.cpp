// SPDX-License-Identifier: MIT
#include "viewer/app/headless.h"

#include <condition_variable>
#include <deque>
#include <fstream>
#include <mutex>
#include <thread>

#include "viewer/app/stb_png.h"

namespace sinew::viewer {

namespace {

constexpr std::size_t kMostWaiting = 4;

struct Job {
  std::filesystem::path file;
  Picture picture;
};

/// Empty when the file was written, else why not.
std::string write_png(const Job& job) {
  const std::vector<unsigned char> bytes = encode_png(job.picture.rgba, job.picture.width, job.picture.height);
  if (bytes.empty()) return job.file.string() + ": the picture cannot be encoded";
  std::ofstream out(job.file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.close();
  return out ? std::string() : job.file.string() + ": cannot be written";
}

}  // namespace

struct PngWriter::State {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Job> waiting;
  bool writing = false, ending = false;
  std::vector<std::string> failures;
  std::thread thread;

  void run() {
    std::unique_lock lock(mutex);
    for (;;) {
      changed.wait(lock, [&] { return ending || !waiting.empty(); });
      if (waiting.empty()) return;
      const Job job = std::move(waiting.front());
      waiting.pop_front();
      writing = true;
      lock.unlock();
      std::string failure = write_png(job);
      lock.lock();
      if (!failure.empty()) failures.push_back(std::move(failure));
      writing = false;
      changed.notify_all();
    }
  }
};

PngWriter::PngWriter() : state_(std::make_unique<State>()) {
  state_->thread = std::thread([state = state_.get()] { state->run(); });
}

PngWriter::~PngWriter() {
  {
    const std::scoped_lock lock(state_->mutex);
    state_->ending = true;
  }
  state_->changed.notify_all();
  state_->thread.join();
}

void PngWriter::write(std::filesystem::path file, Picture picture) {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [&] { return state_->waiting.size() < kMostWaiting; });
  state_->waiting.push_back({std::move(file), std::move(picture)});
  state_->changed.notify_all();
}

std::vector<std::string> PngWriter::finish() {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [&] { return state_->waiting.empty() && !state_->writing; });
  return std::move(state_->failures);
}

}  // namespace sinew::viewer
