// SPDX-License-Identifier: MIT
#include "importer/topology/centers_cache.h"

#include <array>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <span>

#include "importer/write/replace_file.h"
#include "runtime/base/checksum.h"

namespace sinew {
namespace {

/// Adds arrays to a checksum, one after another.
class Hash {
 public:
  void add(std::span<const std::byte> bytes) { value_ = checksum(bytes, value_); }
  template <class T>
  void add_array(const std::vector<T>& values) {
    add(std::as_bytes(std::span(values)));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0;
};

struct Header {
  std::array<char, 8> magic{'s', 'i', 'n', 'e', 'w', 'C', 'o', 'R'};
  std::uint32_t version = 2;
  std::uint32_t vertex_count = 0;
  std::uint64_t data_hash = 0;

  friend bool operator==(const Header&, const Header&) = default;
};

std::uint64_t hash_of(const std::vector<glm::vec3>& centers) { return checksum(std::as_bytes(std::span(centers))); }

}  // namespace

CentersCache::CentersCache(const std::filesystem::path& folder, const Primitive& primitive, double sigma)
    : vertex_count_(primitive.vertex_count()) {
  if (folder.empty()) return;
  Hash hash;
  hash.add(std::as_bytes(std::span(&sigma, 1)));
  hash.add_array(primitive.positions);
  hash.add_array(primitive.indices);
  for (const auto& group : primitive.influences.groups) {
    const std::array<std::uint32_t, 2> shape{group.vertex_count, group.influence_count};
    hash.add(std::as_bytes(std::span(shape)));
  }
  hash.add_array(primitive.influences.joints);
  hash.add_array(primitive.influences.weights);
  char name[32];
  std::snprintf(name, sizeof name, "%016llx.centers", static_cast<unsigned long long>(hash.value()));
  file_ = folder / name;
}

std::optional<std::vector<glm::vec3>> CentersCache::load() const {
  if (file_.empty()) return std::nullopt;
  std::ifstream in(file_, std::ios::binary);
  Header header;
  if (!in.read(reinterpret_cast<char*>(&header), sizeof header)) return std::nullopt;
  std::vector<glm::vec3> centers(vertex_count_);
  const auto bytes = static_cast<std::streamsize>(centers.size() * sizeof(glm::vec3));
  if (!in.read(reinterpret_cast<char*>(centers.data()), bytes)) return std::nullopt;
  Header expected;
  expected.vertex_count = static_cast<std::uint32_t>(vertex_count_);
  expected.data_hash = hash_of(centers);
  if (!(header == expected)) return std::nullopt;
  return centers;
}

void CentersCache::store(const std::vector<glm::vec3>& centers) const {
  if (file_.empty()) return;
  std::error_code ignored;
  std::filesystem::create_directories(file_.parent_path(), ignored);
  Header header;
  header.vertex_count = static_cast<std::uint32_t>(centers.size());
  header.data_hash = hash_of(centers);
  const auto head = std::as_bytes(std::span(&header, 1)), data = std::as_bytes(std::span(centers));
  std::vector<std::byte> bytes(head.begin(), head.end());
  bytes.insert(bytes.end(), data.begin(), data.end());
  // A cache that cannot be written is done without. Of two threads that store the same centers at a time, one does.
  (void)write::replace_file(file_, bytes);
}

}  // namespace sinew
