// SPDX-License-Identifier: MIT
#include "importer/tool/bake/verify_geometry.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "importer/tool/bake/geometry_table.h"
#include "importer/tool/bake/read_cache.h"
#include "importer/tool/messages.h"
#include "importer/tool/progress_line.h"
#include "runtime/geometry_cache/geometry_decoder.h"

namespace sinew::tool {
namespace {

/// Tolerance, as a fraction of the budget: processors with and without fused multiply-add sample the source
/// differently by up to this much.
constexpr double kRounding = 1e-3;

/// Asks for the streams that the cache has, so that the take gets the same shape.
void ask_for_streams(const GeometryCache& cache, TakeSource& source) {
  for (const GeometryMesh& mesh : cache.meshes())
    for (const GeometryStream& stream : mesh.streams) {
      if (stream.kind == GeometryKind::normals) source.budgets.normals_rad = 1.0;
      if (stream.kind == GeometryKind::colors) source.budgets.colors = 1.0;
    }
  source.fps = 1.0 / cache.frame_s();
}

/// The first difference in shape between a take and a cache, as a sentence; empty if there is none.
std::string other_shape(const GeometryTake& take, const GeometryCache& cache) {
  if (take.meshes.size() != cache.meshes().size())
    return fmt::format("it has {}, and the cache {}", counted(take.meshes.size(), "mesh"), cache.meshes().size());
  for (std::size_t m = 0; m < take.meshes.size(); ++m) {
    const TakeMesh& mesh = take.meshes[m];
    const GeometryMesh& baked = cache.meshes()[m];
    if (mesh.vertex_count != baked.vertex_count || mesh.streams.size() != baked.streams.size())
      return fmt::format("mesh {} has {} vertices and {}, and in the cache {} and {}", m, mesh.vertex_count,
                         counted(mesh.streams.size(), "stream"), baked.vertex_count, baked.streams.size());
    if (mesh.streams[0].frames.size() != cache.frame_count())
      return fmt::format("it has {}, and the cache {}", counted(mesh.streams[0].frames.size(), "frame"),
                         cache.frame_count());
  }
  return {};
}

/// The largest error of each stream, in the order of the cache.
using Errors = std::vector<double>;

/// Decodes the frames one after another; with a take, measures their errors.
class GeometryCheck {
 public:
  GeometryCheck(const CacheFile& file, const GeometryTake* take)
      : file_(file), take_(take), decoder_(file.cache), errors_(file.cache.stream_count(), 0.0) {}

  /// Returns the first damaged frame; empty if none is damaged.
  std::optional<std::uint32_t> run() {
    MappedFrames source{file_.cache, file_.bytes};
    ProgressLine progress;
    const std::uint32_t count = file_.cache.frame_count();
    for (std::uint32_t f = 0; f < count; ++f) {
      progress.show("decoding", static_cast<double>(f) / count);
      if (decoder_.decode(f, source) != GeometryStatus::ok) return f;
      std::size_t stream = 0;
      for (std::size_t m = 0; m < file_.cache.meshes().size(); ++m)
        for (std::size_t s = 0; s < file_.cache.meshes()[m].streams.size(); ++s) measure(f, m, s, stream++);
    }
    return std::nullopt;
  }
  const Errors& errors() const { return errors_; }

 private:
  void measure(std::uint32_t frame, std::size_t m, std::size_t s, std::size_t stream) {
    if (take_ == nullptr) return;
    decoded_.resize(file_.cache.meshes()[m].vertex_count);
    decoder_.write_vertices(stream, decoded_);
    const std::vector<glm::vec3>& truth = take_->meshes[m].streams[s].frames[frame];
    for (std::size_t v = 0; v < truth.size(); ++v)
      errors_[stream] = std::max(errors_[stream], glm::distance(glm::dvec3(decoded_[v]), glm::dvec3(truth[v])));
  }

  const CacheFile& file_;
  const GeometryTake* take_;
  GeometryDecoder decoder_;
  std::vector<glm::vec3> decoded_;
  Errors errors_;
};

/// Prints each stream's error (unless `brief`). Returns how many streams exceed the budget.
std::size_t print_errors(const GeometryCache& cache, const Errors& errors, bool brief) {
  std::size_t above = 0, stream = 0;
  for (const GeometryMesh& mesh : cache.meshes())
    for (const GeometryStream& s : mesh.streams) {
      const double error = errors[stream++];
      const bool kept = error <= s.asked * (1.0 + kRounding);
      above += kept ? 0 : 1;
      if (brief) continue;
      print_result("  {} of {}: {} measured anew, {} in the file, {} asked{}\n", tool::name_of(s.kind),
                   in_quotes(mesh.name), error_text(s.kind, error), error_text(s.kind, s.measured),
                   error_text(s.kind, s.asked), kept ? "" : ": NOT kept");
    }
  return above;
}

/// The exit code for a cache or source that cannot be read: cannot_read, to tell it from a damaged frame.
ExitCode unread(ExitCode code) { return code == ExitCode::input_at_fault ? ExitCode::cannot_read : code; }

}  // namespace

std::optional<ExitCode> verify_geometry(const std::string& file, std::optional<TakeSource> source, bool brief) {
  const auto read = read_cache(file, true);
  if (!read) return std::nullopt;
  if (!*read) return unread(read->error());
  const CacheFile& in = **read;
  std::optional<GeometryTake> take;
  if (source) {
    ask_for_streams(in.cache, *source);
    auto truth = read_take(*source);
    if (!truth) return unread(truth.error());
    if (const std::string other = other_shape(*truth, in.cache); !other.empty())
      return fail_with(ExitCode::input_at_fault, fmt::format("{}: verify-shape: {}", source->file, other));
    take = std::move(*truth);
  }
  GeometryCheck check(in, take ? &*take : nullptr);
  if (const auto damaged = check.run()) {
    const std::uint64_t byte = in.cache.frames()[*damaged].offset;
    return fail_with(ExitCode::input_at_fault,
                     fmt::format("{}: byte {}: cache-frame: frame {} is not as it was written", file, byte, *damaged));
  }
  print_result("{}: {} decoded, every checksum is right\n", file, counted(in.cache.frame_count(), "frame"));
  if (!take) {
    if (!brief) print_result_text(geometry_table(in.cache));
    return ExitCode::done;
  }
  if (const std::size_t above = print_errors(in.cache, check.errors(), brief); above > 0)
    return fail_with(ExitCode::input_at_fault,
                     fmt::format("{}: {} of {} differ from {} by more than was asked", file, above,
                                 counted(check.errors().size(), "stream"), source->file));
  return ExitCode::done;
}

}  // namespace sinew::tool
