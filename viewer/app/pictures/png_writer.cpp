// SPDX-License-Identifier: MIT
#include "viewer/app/pictures/png_writer.h"

#include <zlib.h>

#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <limits>
#include <mutex>
#include <span>
#include <thread>

namespace {

/// Compresses with run lengths and Huffman codes only (Z_RLE). On filtered renderings, a full match search takes three
/// times as long and saves only a fifth of the bytes.
unsigned char* zlib_stream(unsigned char* bytes, int count, int* packed_count, int) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, 15, 9, Z_RLE) != Z_OK) return nullptr;
  const uLong most = deflateBound(&stream, static_cast<uLong>(count));
  auto* packed = static_cast<unsigned char*>(std::malloc(most));
  stream.next_in = bytes;
  stream.avail_in = static_cast<uInt>(count);
  stream.next_out = packed;
  stream.avail_out = static_cast<uInt>(most);
  if (packed) deflate(&stream, Z_FINISH);  // one call suffices: the buffer holds the worst case
  *packed_count = static_cast<int>(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

}  // namespace

// stb's PNG encoder, with internal linkage, because other libraries may contain a copy.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS zlib_stream
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace sinew::viewer {

namespace {

constexpr std::size_t kMostWaiting = 4;

struct Job {
  std::filesystem::path file;
  Picture picture;
};

/// A PNG file in memory, 8 bits RGBA; empty when the size is wrong or memory ran out.
std::vector<unsigned char> encode_png(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height) {
  constexpr auto most = static_cast<std::uint32_t>(std::numeric_limits<std::int16_t>::max());
  if (width == 0 || height == 0 || width > most || height > most || rgba.size() != std::size_t{4} * width * height)
    return {};
  stbi_write_force_png_filter = 1;  // filter 1 (Sub) for all rows; trying every filter takes longer than compressing
  std::vector<unsigned char> bytes;
  const auto append = [](void* context, void* data, int size) {
    const auto* first = static_cast<const unsigned char*>(data);
    static_cast<std::vector<unsigned char>*>(context)->insert(static_cast<std::vector<unsigned char>*>(context)->end(),
                                                              first, first + size);
  };
  const int done = stbi_write_png_to_func(append, &bytes, static_cast<int>(width), static_cast<int>(height), 4,
                                          rgba.data(), static_cast<int>(4 * width));
  return done ? bytes : std::vector<unsigned char>{};
}

/// Writes the file. Empty on success, else the reason.
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
