// SPDX-License-Identifier: MIT
#include "importer/file/sandboxed_files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "importer/issue_log.h"
#include "importer/visible_text.h"

namespace sinew {
namespace fs = std::filesystem;
namespace {

tl::unexpected<FileFault> fault(FileFault::Kind kind, std::string detail) {
  return tl::make_unexpected(FileFault{kind, std::move(detail)});
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// True if the URI starts with a scheme (RFC 3986): a letter, then letters, digits, "+", "-" or ".", then ":".
bool has_scheme(std::string_view uri) {
  const auto colon = uri.find(':');
  if (colon == uri.npos || colon == 0 || !std::isalpha(static_cast<unsigned char>(uri.front()))) return false;
  return std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.';
  });
}

tl::unexpected<FileFault> absolute_fault() {
  return fault(FileFault::Kind::forbidden,
               "the URI is not relative; name the file by its path from the folder of this file");
}

/// Names the scheme. A single letter is not a scheme but a Windows drive.
tl::unexpected<FileFault> scheme_fault(std::string_view uri) {
  const std::string scheme(uri.substr(0, uri.find(':') + 1));
  if (scheme.size() == 2)
    return fault(FileFault::Kind::forbidden,
                 "the URI names the drive " + scheme +
                     "; name the file by its path from the folder of this file, with / between folders");
  return fault(FileFault::Kind::forbidden, "the URI has the scheme " + in_quotes(scheme) +
                                               "; only data: and paths from the folder of this file are read");
}

/// A usual reason why a name leads to no file, as the end of a sentence; may be empty.
std::string missing_hint(std::string_view name) {
  if (!is_utf8(name)) return "; its bytes are not UTF-8, as those of a URI are";
  if (name.find('\\') != name.npos) return "; a URI has / between folders, not \\";
  return {};
}

bool lies_below(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

}  // namespace

std::optional<std::string> percent_decode(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    if (text.size() - i < 3) return std::nullopt;
    const int high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
    if (high < 0 || low < 0) return std::nullopt;
    out += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return out;
}

tl::expected<fs::path, FileFault> SandboxedFiles::resolve(std::string_view uri) const {
  using Kind = FileFault::Kind;
  if (has_scheme(uri)) return scheme_fault(uri);
  if (!folder_) return fault(Kind::forbidden, "a document in memory has no folder to read from");
  const auto decoded = percent_decode(uri);
  if (!decoded) return fault(Kind::forbidden, "the URI has a broken percent escape");
  if (decoded->empty()) return fault(Kind::forbidden, "the URI is empty");
  if (decoded->find('\0') != decoded->npos) return fault(Kind::forbidden, "the URI holds a zero byte");
  if (has_scheme(*decoded)) return scheme_fault(*decoded);
  if (decoded->front() == '/' || decoded->front() == '\\') return absolute_fault();
  const fs::path relative(std::u8string(decoded->begin(), decoded->end()));
  if (relative.is_absolute()) return absolute_fault();
  std::error_code error;
  const fs::path root = fs::canonical(folder_->empty() ? fs::path(".") : *folder_, error);
  if (error) return fault(Kind::missing, "the folder of the file cannot be opened: " + error.message());
  // Checks the path text first, so that the result does not reveal which files exist outside the folder.
  const fs::path textual = (root / relative).lexically_normal();
  if (!lies_below(textual, root)) return fault(Kind::forbidden, "the URI leads out of the file's folder");
  const fs::path target = fs::canonical(root / relative, error);
  if (error)
    return fault(Kind::missing,
                 std::string("\"") + *decoded + "\" cannot be opened: " + error.message() + missing_hint(*decoded));
  if (!lies_below(target, root)) return fault(Kind::forbidden, "the URI leads out of the file's folder by a link");
  return target;
}

bool SandboxedFiles::take(std::uint64_t bytes) noexcept {
  if (bytes > left_) return false;
  left_ -= bytes;
  read_ += bytes;
  return true;
}

tl::expected<std::vector<std::byte>, FileFault> SandboxedFiles::read_all(const RegularFile& file) {
  using Kind = FileFault::Kind;
  const auto size = file.size();
  if (!size) return fault(Kind::missing, "not a regular file");
  if (!take(*size)) return fault(Kind::too_large, std::to_string(*size) + " bytes are more than allowed");
  std::vector<std::byte> bytes(static_cast<std::size_t>(*size));
  if (!file.read(bytes)) return fault(Kind::missing, "the file cannot be read");
  return bytes;
}

tl::expected<std::vector<std::byte>, FileFault> SandboxedFiles::read_path(const fs::path& path) {
  const RegularFile file(path);
  if (!file.opened()) return fault(FileFault::Kind::missing, std::strerror(errno));
  paths_.insert(path);
  return read_all(file);
}

tl::expected<std::span<const std::byte>, FileFault> SandboxedFiles::read(std::string_view uri,
                                                                         std::deque<std::vector<std::byte>>& storage) {
  const auto path = resolve(uri);
  if (!path) return tl::make_unexpected(path.error());
  const RegularFile file(*path);
  if (!file.opened()) return fault(FileFault::Kind::missing, std::strerror(errno));
  const auto known = contents_.find(file.identity());
  if (known != contents_.end()) return known->second;
  auto bytes = read_all(file);
  if (!bytes) return tl::make_unexpected(std::move(bytes.error()));
  paths_.insert(*path);
  const std::span<const std::byte> kept = storage.emplace_back(std::move(*bytes));
  contents_.emplace(file.identity(), kept);
  return kept;
}

void SandboxedFiles::note(std::string_view uri) {
  if (auto path = resolve(uri)) paths_.insert(std::move(*path));
}

}  // namespace sinew
