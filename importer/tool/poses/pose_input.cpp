// SPDX-License-Identifier: MIT
#include "importer/tool/poses/pose_input.h"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <utility>

#include <rapidjson/reader.h>

#include "importer/file/regular_file.h"
#include "importer/platform/files.h"
#include "importer/tool/poses/pose_events.h"

namespace sinew::tool {
namespace {

ImportIssue file_issue(std::string detail) { return {Severity::error, "pose-file", "", std::move(detail)}; }

/// The characters of a file, unpacked if it is compressed. It is a stream in RapidJSON's sense, which ends with '\0'.
class UnpackedText {
 public:
  using Ch = char;

  /// `file` stays open during the life of this object.
  UnpackedText(const RegularFile& file, std::uint64_t most_bytes)
      : file_(gzdopen(platform::duplicate(file.descriptor()), "rb")), left_(most_bytes) {
    if (file_ == nullptr) fault_ = std::strerror(errno);
    fill();
  }
  ~UnpackedText() {
    if (file_ != nullptr) gzclose(file_);
  }
  UnpackedText(const UnpackedText&) = delete;
  UnpackedText& operator=(const UnpackedText&) = delete;

  Ch Peek() const { return at_ < count_ ? block_[at_] : '\0'; }
  Ch Take() {
    const Ch c = Peek();
    if (++at_ >= count_) fill();
    return c;
  }
  std::size_t Tell() const { return before_ + at_; }

  // For streams that are written to, which this one is not.
  Ch* PutBegin() { return nullptr; }
  void Put(Ch) {}
  void Flush() {}
  std::size_t PutEnd(Ch*) { return 0; }

  bool ended() const { return at_ >= count_; }

  /// Unpacks the rest of the file, since only the end of a compressed file has its checksum.
  /// out   empty, or why the file cannot be read
  std::string finish() {
    while (count_ > 0) fill();
    if (file_ != nullptr && gzclose(std::exchange(file_, nullptr)) == Z_BUF_ERROR && fault_.empty()) fault_ = kDamaged;
    return fault_;
  }

 private:
  static constexpr const char* kDamaged = "is damaged or cut short";

  void fill() {
    before_ += count_;
    at_ = count_ = 0;
    if (file_ == nullptr || !fault_.empty()) return;
    const int got = gzread(file_, block_, sizeof block_);
    if (got < 0) {
      fault_ = kDamaged;
      return;
    }
    count_ = static_cast<std::size_t>(got);
    if (count_ > left_) fault_ = "unpacks to more than 256 times its size";
    left_ -= std::min<std::uint64_t>(left_, count_);
  }

  gzFile file_;
  std::uint64_t left_;
  std::string fault_;
  std::size_t before_ = 0, at_ = 0, count_ = 0;
  char block_[std::size_t{1} << 16];
};

constexpr unsigned kFlags =
    rapidjson::kParseNumbersAsStringsFlag | rapidjson::kParseValidateEncodingFlag | rapidjson::kParseIterativeFlag;

/// in   at_end  returns true if a '\0' that the stream gave was its end
template <class Stream, class AtEnd>
tl::expected<PoseSummary, ImportIssue> parse(Stream& stream, const PoseSink& sink, const AtEnd& at_end) {
  PoseEvents events(sink);
  rapidjson::Reader reader;
  const rapidjson::ParseResult result = reader.Parse<kFlags>(stream, events);
  if (events.stopped) return std::move(events.summary);
  const bool ended_by_us = result.Code() == rapidjson::kParseErrorTermination && events.issue;
  if (!ended_by_us && (result.IsError() || !at_end())) return tl::unexpected(file_issue("is not JSON"));
  if (events.issue) return tl::unexpected(*std::move(events.issue));
  return std::move(events.summary);
}

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

tl::expected<PoseSummary, ImportIssue> parse_poses(std::string_view text, const PoseSink& sink) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  rapidjson::MemoryStream stream(text.data(), text.size());
  return parse(stream, sink, [&] { return stream.Tell() == text.size(); });
}

tl::expected<PoseSummary, ImportIssue> read_poses(const std::string& file, const PoseSink& sink) {
  const RegularFile opened(platform::path_of(file));
  if (!opened.opened()) return tl::unexpected(file_issue(std::strerror(errno)));
  const auto packed_bytes = opened.size();
  if (!packed_bytes) return tl::unexpected(file_issue("is not a regular file"));
  UnpackedText text(opened, 256 * *packed_bytes + (std::uint64_t{1} << 20));
  if (text.Peek() == kByteOrderMark[0])
    for (const char c : kByteOrderMark)
      if (text.Take() != c) return tl::unexpected(file_issue("is not JSON"));
  auto summary = parse(text, sink, [&] { return text.ended(); });
  const std::string fault = text.finish();
  if (!fault.empty()) return tl::unexpected(file_issue(fault));
  return summary;
}

}  // namespace sinew::tool
