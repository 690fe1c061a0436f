// SPDX-License-Identifier: MIT
#include "viewer/device/disk_cache.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <ios>

#include "runtime/base/checksum.h"

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostBytes = std::uint64_t{256} << 20;  // larger cache files are not read

struct Header {
  std::array<char, 8> magic{'s', 'i', 'n', 'e', 'w', 'D', 'C', '1'};
  std::uint64_t key = 0, bytes = 0, checksum = 0;

  friend bool operator==(const Header&, const Header&) = default;
};

Header header_of(std::uint64_t key, std::span<const std::byte> bytes) {
  Header header;
  header.key = key;
  header.bytes = bytes.size();
  header.checksum = checksum(bytes);
  return header;
}

}  // namespace

std::optional<std::vector<std::byte>> DiskCache::load(const std::string& name, std::uint64_t key) const {
  if (!on()) return std::nullopt;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(folder_ / name, error);
  if (error || size < sizeof(Header) || size > kMostBytes) return std::nullopt;
  std::ifstream in(folder_ / name, std::ios::binary);
  Header header;
  std::vector<std::byte> bytes(size - sizeof(Header));
  in.read(reinterpret_cast<char*>(&header), sizeof header);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!in || !(header == header_of(key, bytes))) return std::nullopt;
  return bytes;
}

void DiskCache::store(const std::string& name, std::uint64_t key, std::span<const std::byte> bytes) const {
  if (!on()) return;
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  // A unique name, because several processes may store at the same time.
  std::string unfinished = (folder_ / (name + ".XXXXXX")).string();
  const int descriptor = ::mkstemp(unfinished.data());
  if (descriptor < 0) return;
  ::close(descriptor);
  {
    std::ofstream out(unfinished, std::ios::binary);
    const Header header = header_of(key, bytes);
    out.write(reinterpret_cast<const char*>(&header), sizeof header);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    out.flush();
    if (out) fs::rename(unfinished, folder_ / name, ignored);
  }
  fs::remove(unfinished, ignored);  // cleans up if the rename failed; after a success it no longer exists
}

}  // namespace sinew::viewer
