// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/bind_geometry.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "runtime/base/index.h"

namespace sinew {
namespace {

/// The name that `sinew bake` gives the mesh.
std::string name_of(const Mesh& mesh, std::size_t primitive) {
  return mesh.primitives.size() == 1 ? mesh.name : mesh.name + " " + std::to_string(primitive);
}

std::string in_quotes(const std::string& name) { return "\"" + name + "\""; }

/// Binds one instance after another; each mesh of the cache is bound at most once.
class NameBinder {
 public:
  NameBinder(const GeometryCache& cache, const Scene& scene)
      : cache_(cache), scene_(scene), taken_(cache.meshes().size()) {}

  void bind(std::uint32_t instance) {
    const Mesh& mesh = scene_.meshes[scene_.instances[instance].mesh];
    std::vector<GeometryBinding> bindings;
    for (std::uint32_t p = 0; p < mesh.primitives.size(); ++p) {
      const std::uint32_t found = find(name_of(mesh, p));
      if (found == kNone) continue;
      taken_[found] = true;
      if (match_vertices(cache_.meshes()[found], mesh.primitives[p]))
        bindings.push_back({instance, p, found});
      else
        report_unbound(instance, "the triangles of " + in_quotes(cache_.meshes()[found].name) + " are others");
    }
    if (bindings.empty()) return;
    if (bindings.size() == mesh.primitives.size())
      out_.bound.insert(out_.bound.end(), bindings.begin(), bindings.end());
    else
      report_unbound(instance, "the cache has some of its primitives only");
  }

  GeometryBindings finish() {
    for (std::size_t m = 0; m < taken_.size(); ++m)
      if (!taken_[m])
        out_.unbound.push_back("mesh " + in_quotes(cache_.meshes()[m].name) + " of the cache: no such name");
    return std::move(out_);
  }

 private:
  std::uint32_t find(const std::string& name) const {
    for (std::uint32_t m = 0; m < taken_.size(); ++m)
      if (!taken_[m] && cache_.meshes()[m].name == name) return m;
    return kNone;
  }

  void report_unbound(std::uint32_t instance, const std::string& why) {
    out_.unbound.push_back("mesh instance " + std::to_string(instance) + " " +
                           in_quotes(scene_.meshes[scene_.instances[instance].mesh].name) + ": " + why);
  }

  const GeometryCache& cache_;
  const Scene& scene_;
  std::vector<bool> taken_;
  GeometryBindings out_;
};

}  // namespace

GeometryBindings bind_by_name(const GeometryCache& cache, const Scene& scene) {
  NameBinder binder(cache, scene);
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) binder.bind(i);
  return binder.finish();
}

Result<std::vector<std::uint32_t>> match_vertices(const GeometryMesh& mesh, const Primitive& primitive) {
  std::vector<std::uint32_t> taken(primitive.vertex_count(), kNone);
  const bool by_corners = !mesh.triangles.empty() && primitive.topology == Topology::triangles;
  if (by_corners ? mesh.triangles.size() != primitive.indices.size() : mesh.vertex_count != taken.size())
    return tl::unexpected(ErrorCode::size_mismatch);
  if (!by_corners || mesh.triangles == primitive.indices) {
    if (mesh.vertex_count != taken.size()) return tl::unexpected(ErrorCode::size_mismatch);
    std::iota(taken.begin(), taken.end(), 0u);
    return taken;
  }
  for (std::size_t c = 0; c < primitive.indices.size(); ++c) {
    std::uint32_t& vertex = taken[primitive.indices[c]];
    if (vertex != kNone && vertex != mesh.triangles[c]) return tl::unexpected(ErrorCode::unsupported);
    vertex = mesh.triangles[c];
  }
  for (std::uint32_t& vertex : taken)
    if (vertex == kNone) vertex = 0;  // part of no triangle, so never visible
  return taken;
}

ErrorCode check(const GeometryCache& cache, const Scene& scene, std::span<const GeometryBinding> bindings) {
  std::vector<std::vector<bool>> bound(scene.instances.size());
  for (const GeometryBinding& binding : bindings) {
    if (binding.instance >= scene.instances.size() || binding.mesh >= cache.meshes().size())
      return ErrorCode::index_out_of_range;
    const Mesh& mesh = scene.meshes[scene.instances[binding.instance].mesh];
    if (binding.primitive >= mesh.primitives.size()) return ErrorCode::index_out_of_range;
    std::vector<bool>& primitives = bound[binding.instance];
    primitives.resize(mesh.primitives.size());
    if (primitives[binding.primitive]) return ErrorCode::unsupported;
    primitives[binding.primitive] = true;
    const auto matched = match_vertices(cache.meshes()[binding.mesh], mesh.primitives[binding.primitive]);
    if (!matched) return matched.error();
  }
  const auto in_part = [](const std::vector<bool>& all) {
    return std::find(all.begin(), all.end(), false) != all.end();
  };
  return std::any_of(bound.begin(), bound.end(), in_part) ? ErrorCode::unsupported : ErrorCode::ok;
}

}  // namespace sinew
