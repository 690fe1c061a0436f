// SPDX-License-Identifier: MIT
#include "importer/tool/poses/npz_file.h"

#include <zlib.h>

#include "importer/tool/poses/zip_records.h"
#include "runtime/base/contract.h"

namespace sinew::tool {
namespace {

std::uint32_t checksum_of(std::uint32_t before, std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace

std::size_t NpzFile::add(const NpyArray& array) {
  Entry entry{.name = array.name + ".npy", .at = end_};
  const std::string head = npy_head(array);
  entry.size = head.size() + array.byte_size();
  entry.data_at = end_ + zip_local_head(entry.name, 0, entry.size).size();
  end_ = entry.data_at + entry.size;
  entries_.push_back(std::move(entry));
  append(entries_.size() - 1, head);
  return entries_.size() - 1;
}

void NpzFile::append(std::size_t array, std::string_view bytes) {
  Entry& entry = entries_[array];
  CONTRACT(entry.done + entry.held.size() + bytes.size() <= entry.size);
  entry.held += bytes;
  held_ += bytes.size();
  if (held_ > kHeld) flush_all();
}

void NpzFile::flush(Entry& entry) {
  entry.checksum = checksum_of(entry.checksum, entry.held);
  out_.write_at(entry.data_at + entry.done, entry.held);
  entry.done += entry.held.size();
  entry.held = {};
}

void NpzFile::flush_all() {
  for (Entry& entry : entries_) flush(entry);
  held_ = 0;
}

void NpzFile::finish() {
  flush_all();
  std::string directory;
  for (const Entry& entry : entries_) {
    CONTRACT(entry.done == entry.size);
    out_.write_at(entry.at, zip_local_head(entry.name, entry.checksum, entry.size));
    directory += zip_directory_entry(entry.name, entry.checksum, entry.size, entry.at);
  }
  out_.write_at(end_, directory + zip_ending(entries_.size(), end_, directory.size()));
}

}  // namespace sinew::tool
