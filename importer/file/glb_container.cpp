// SPDX-License-Identifier: MIT
#include "importer/file/glb_container.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace sinew {
namespace {

using Bytes = std::span<const std::byte>;
constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
constexpr std::uint32_t kJson = 0x4E4F534A;   // "JSON"
constexpr std::uint32_t kBin = 0x004E4942;    // "BIN\0"

std::uint32_t read_u32(Bytes bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
    value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

/// True if the head contains U+FFFD, the UTF-8 sign for bytes that are no text: the file was converted as if it were
/// text. As a length these bytes would mean more than 180 MB.
bool was_converted(Bytes file) noexcept {
  for (std::size_t at = 8; at + 3 <= std::min<std::size_t>(file.size(), 20); ++at)
    if ((read_u32(file, at - 1) >> 8) == 0xBDBFEF) return true;
  return false;
}

/// Checks the header and returns the bytes within its declared length.
std::optional<Bytes> check_header(Bytes file, IssueLog& log) {
  const auto fail = [&](std::string detail) {
    log.report(Rule::glb_header, "", std::move(detail));
    return std::nullopt;
  };
  if (file.size() < 12) return fail("the file has " + std::to_string(file.size()) + " bytes, a header needs 12");
  if (read_u32(file, 0) != kMagic) return fail("the file does not start with \"glTF\"");
  if (const auto version = read_u32(file, 4); version != 2)
    return fail("container version " + std::to_string(version) + " is not 2" +
                (version == 1 ? "; convert the file to glTF 2.0" : ""));
  const std::uint64_t length = read_u32(file, 8);
  if (length < 12 || length > file.size())
    return fail("the header says " + std::to_string(length) + " bytes, the file has " + std::to_string(file.size()) +
                (was_converted(file) ? "; a program converted its bytes as if they were text: copy or download it again"
                 : length < 12       ? ""
                                     : "; it is cut off: copy or download it again"));
  if (length < file.size())
    log.report(Rule::glb_extra_data, "", std::to_string(file.size() - length) + " bytes after the end are ignored");
  return file.first(static_cast<std::size_t>(length));
}

struct Chunk {
  std::uint32_t type = 0;
  Bytes data;
};

/// True if the bytes at `at` can be a chunk: BIN, and inside the file.
bool looks_like_bin(Bytes file, std::size_t at) noexcept {
  return at < file.size() && file.size() - at >= 8 && read_u32(file, at + 4) == kBin &&
         read_u32(file, at) <= file.size() - at - 8;
}

/// Finds the begin of the chunk after an unaligned one: at its end, or after padding that its length leaves out.
/// in   end   end of the unaligned chunk
std::size_t find_next_chunk(Bytes file, std::size_t end) noexcept {
  const std::size_t aligned = (end + 3) / 4 * 4;
  if (aligned >= file.size()) return file.size();
  return !looks_like_bin(file, end) && looks_like_bin(file, aligned) ? aligned : end;
}

std::optional<Chunk> next_chunk(Bytes file, std::size_t& at, IssueLog& log) {
  const auto place = "the chunk at byte " + std::to_string(at);
  if (file.size() - at < 8) {
    log.report(Rule::glb_chunk, "", place + " has no room for its header");
    return std::nullopt;
  }
  const std::size_t length = read_u32(file, at);
  if (length > file.size() - at - 8) {
    log.report(Rule::glb_chunk, "",
               place + " says " + std::to_string(length) + " bytes, " + std::to_string(file.size() - at - 8) +
                   " are left: the file is cut off, or a program changed its bytes");
    return std::nullopt;
  }
  const Chunk chunk{read_u32(file, at + 4), file.subspan(at + 8, length)};
  at += 8 + length;
  if (length % 4 != 0) {
    log.report(Rule::glb_alignment, "",
               place + " has " + std::to_string(length) + " bytes, not a multiple of 4; read all the same");
    at = find_next_chunk(file, at);
  }
  return chunk;
}

}  // namespace

bool looks_like_glb(Bytes file) noexcept { return file.size() >= 4 && read_u32(file, 0) == kMagic; }

std::optional<Container> open_glb(Bytes file, IssueLog& log) {
  const auto body = check_header(file, log);
  if (!body) return std::nullopt;
  const auto fail = [&](const char* detail) {
    log.report(Rule::glb_chunk, "", detail);
    return std::nullopt;
  };
  Container parts;
  std::size_t index = 0;
  for (std::size_t at = 12; at < body->size(); ++index) {
    const auto chunk = next_chunk(*body, at, log);
    if (!chunk) return std::nullopt;
    if (index == 0 && chunk->type != kJson) return fail("the first chunk is not JSON");
    if (index > 0 && chunk->type == kJson) return fail("there is a second JSON chunk");
    if (chunk->type == kJson) {
      parts.json = chunk->data;
    } else if (chunk->type == kBin) {
      if (index != 1) return fail(parts.bin ? "there is a second BIN chunk" : "the BIN chunk is not the second chunk");
      parts.bin = chunk->data;
    } else {
      log.report(Rule::glb_extra_data, "", "chunk " + std::to_string(index) + " has an unknown type and is ignored");
    }
  }
  if (parts.json.empty()) return fail("there is no JSON chunk, or it is empty");
  return parts;
}

}  // namespace sinew
