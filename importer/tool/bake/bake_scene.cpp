// SPDX-License-Identifier: MIT
#include "importer/tool/bake/bake_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "importer/tool/messages.h"
#include "importer/tool/progress_line.h"
#include "runtime/math/affine.h"
#include "runtime/math/normal_transform.h"
#include "runtime/plan/run_plan.h"

namespace sinew::tool {
namespace {

/// The primitive of a mesh instance that one mesh of the cache (TakeMesh) is baked from.
struct Source {
  std::uint32_t instance = 0, primitive = 0;
};

class SceneBaker {
 public:
  SceneBaker(const Scene& scene, std::uint32_t clip, const TakeBudgets& budgets)
      : scene_(scene),
        clip_(clip),
        budgets_(budgets),
        plan_(compile_plan(lend(scene), needs(budgets))),
        frame_(plan_) {}

  void add_meshes(BakedScene& out) {
    for (std::uint32_t i = 0; i < scene_.instances.size(); ++i) {
      const Mesh& mesh = scene_.meshes[scene_.instances[i].mesh];
      if (!scene_.instances[i].copies.empty())
        out.left_out.push_back(fmt::format("copies of mesh {}: only the mesh itself is baked", in_quotes(mesh.name)));
      for (std::uint32_t p = 0; p < mesh.primitives.size(); ++p) {
        const Primitive& primitive = mesh.primitives[p];
        if (primitive.topology != Topology::triangles) {
          out.left_out.push_back(fmt::format("points or lines of mesh {}", in_quotes(mesh.name)));
          continue;
        }
        sources_.push_back({i, p});
        TakeMesh& taken = out.take.meshes.emplace_back();
        taken.name = mesh.primitives.size() == 1 ? mesh.name : fmt::format("{} {}", mesh.name, p);
        taken.vertex_count = static_cast<std::uint32_t>(primitive.vertex_count());
        taken.triangles = primitive.indices;
        taken.streams.push_back({GeometryKind::positions, {}, budgets_.positions_m});
        // If a vector differs from a unit vector by the sine of an angle, it is turned by that angle at most.
        if (budgets_.normals_rad && !primitive.normals.empty())
          taken.streams.push_back({GeometryKind::normals, {}, std::sin(*budgets_.normals_rad)});
        if (budgets_.colors && !primitive.colors.empty()) {
          taken.streams.push_back({GeometryKind::colors, {}, *budgets_.colors});
          if (std::any_of(primitive.colors.begin(), primitive.colors.end(),
                          [](const glm::vec4& c) { return c.a != 1; }))
            out.left_out.push_back(fmt::format("alpha of the colours of mesh {}", in_quotes(mesh.name)));
        }
      }
    }
  }

  ErrorCode run(double time_s) {
    const ClipLayer layers[] = {{.clip = clip_, .time_s = time_s}};
    FrameInput input;
    if (clip_ != kNone) input.layers = layers;
    return run_plan(plan_, input, frame_);
  }

  /// The vertices of one mesh of the take in the last evaluated frame.
  std::vector<glm::vec3> values(std::size_t source, GeometryKind kind) const {
    const auto [i, p] = sources_[source];
    const InstanceResult& instance = frame_.result().instances[i];
    const DeformedPrimitive& deformed = frame_.result().primitives[instance.first_primitive + p];
    const Primitive& rest = scene_.meshes[scene_.instances[i].mesh].primitives[p];
    const auto shown = [](const auto& moved, const auto& still) { return moved.empty() ? std::span(still) : moved; };
    std::vector<glm::vec3> out;
    out.reserve(rest.vertex_count());
    const auto turn = linear_part(instance.world_from_mesh);
    switch (kind) {
      case GeometryKind::positions:
        for (const glm::vec3& x : shown(deformed.positions, rest.positions))
          out.push_back(transform_point(instance.world_from_mesh, x));
        break;
      case GeometryKind::normals:
        for (const glm::vec3& n : shown(deformed.normals, rest.normals)) out.push_back(transform_normal(turn, n));
        break;
      case GeometryKind::colors:
        for (const glm::vec4& c : shown(deformed.colors, rest.colors)) out.emplace_back(c.r, c.g, c.b);
        break;
    }
    return out;
  }

 private:
  static Needs needs(const TakeBudgets& budgets) {
    Needs needs;
    needs.out.normals = budgets.normals_rad.has_value();
    needs.out.joints = needs.out.tangents = needs.out.properties = needs.out.weights = false;
    needs.out.hidden_meshes = true;
    needs.in.max_layers = 1;
    return needs;
  }

  const Scene& scene_;
  std::uint32_t clip_;
  TakeBudgets budgets_;
  Plan plan_;
  FrameBuffer frame_;
  std::vector<Source> sources_;
};

}  // namespace

tl::expected<BakedScene, std::string> bake_scene(const Scene& scene, std::uint32_t clip, double fps,
                                                 const TakeBudgets& budgets, std::size_t most_frames) {
  const double duration_s = clip == kNone ? 0.0 : scene.animations[clip].duration_s;
  if (duration_s * fps > static_cast<double>(kMostBakedFrames))
    return tl::unexpected(fmt::format("--fps {}: more than {} frames", fps, kMostBakedFrames));
  const std::size_t frames = std::min(most_frames, static_cast<std::size_t>(std::floor(duration_s * fps + 1e-6)) + 1);
  BakedScene out;
  out.take.frame_s = 1.0 / fps;
  SceneBaker baker(scene, clip, budgets);
  baker.add_meshes(out);
  ProgressLine progress;
  for (std::size_t half = 0; half < 2 * frames - 1; ++half) {  // frames, and the times halfway between them
    progress.show("sampling", static_cast<double>(half) / static_cast<double>(2 * frames));
    if (const ErrorCode code = baker.run(static_cast<double>(half) / (2.0 * fps)); code != ErrorCode::ok)
      return tl::unexpected(std::string(describe(code)));
    for (std::size_t m = 0; m < out.take.meshes.size(); ++m) {
      TakeMesh& mesh = out.take.meshes[m];
      if (half % 2 == 1) mesh.between.push_back(baker.values(m, GeometryKind::positions));
      if (half % 2 == 0)
        for (TakeStream& stream : mesh.streams) stream.frames.push_back(baker.values(m, stream.kind));
    }
  }
  return out;
}

}  // namespace sinew::tool
