// SPDX-License-Identifier: MIT
#include "importer/decode/decode_draco.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <draco/mesh/mesh.h>
#pragma GCC diagnostic pop

#include <array>
#include <cstring>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "importer/decode/draco_stream.h"
#include "importer/decode/mend_decoded.h"
#include "importer/file/json_pointer.h"
#include "importer/file/json_shape.h"
#include "importer/read/accessor.h"

namespace sinew {
namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";
constexpr JsonValueShape kDracoIndex{.kind = JsonKind::integer, .lower = 0, .upper = 2147483646.0};
constexpr JsonProperty kDracoProperties[] = {
    {"bufferView", kDracoIndex, true}, {"attributes", {.kind = JsonKind::index_map, .element = &kDracoIndex}, true}};
constexpr JsonObjectShape kDracoObject{kDracoProperties};
constexpr JsonValueShape kDracoShape{.kind = JsonKind::object, .object = &kDracoObject};

template <class T>
bool copy_values(const draco::Mesh& mesh, const draco::PointAttribute& attribute, std::vector<std::byte>& out) {
  const std::size_t components = attribute.num_components();
  std::vector<T> value(components);
  std::byte* to = out.data();
  for (std::uint32_t p = 0; p < mesh.num_points(); ++p, to += components * sizeof(T)) {
    if (!attribute.ConvertValue(attribute.mapped_index(draco::PointIndex(p)), value.data())) return false;
    std::memcpy(to, value.data(), components * sizeof(T));
  }
  return true;
}

bool copy_values(gltf::ComponentType type, const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                 std::vector<std::byte>& out) {
  switch (type) {
    case gltf::ComponentType::i8: return copy_values<std::int8_t>(mesh, attribute, out);
    case gltf::ComponentType::u8: return copy_values<std::uint8_t>(mesh, attribute, out);
    case gltf::ComponentType::i16: return copy_values<std::int16_t>(mesh, attribute, out);
    case gltf::ComponentType::u16: return copy_values<std::uint16_t>(mesh, attribute, out);
    case gltf::ComponentType::u32: return copy_values<std::uint32_t>(mesh, attribute, out);
    case gltf::ComponentType::f32: break;
  }
  return copy_values<float>(mesh, attribute, out);
}

class DracoDecoder {
 public:
  DracoDecoder(gltf::Document& document, DecodeBudget& budget, IssueLog& log)
      : document_(document), budget_(budget), log_(log) {}

  void decode(gltf::Primitive& primitive, const std::string& primitive_place) {
    const gltf::Json& extension = primitive.extensions[kDraco];
    place_ = pointer(primitive_place, "extensions", kDraco);
    const std::size_t errors = log_.error_count();
    check_shape(extension, kDracoShape, place_, log_);
    if (log_.error_count() != errors) return;
    const bool strip = gltf::mode_of(primitive) == gltf::PrimitiveMode::triangle_strip;
    if (!strip && gltf::mode_of(primitive) != gltf::PrimitiveMode::triangles)
      return fail("only triangles and strips can be compressed");
    if (primitive.indices == gltf::kAbsent) return fail("the primitive has no indices");
    const auto view = static_cast<std::uint32_t>(extension["bufferView"].get<double>());
    const auto mesh = mesh_of(view);
    if (mesh == nullptr) return;

    primitive.mode = TINYGLTF_MODE_TRIANGLES;  // the decoder returns triangle lists, even for strips
    if (claim(primitive.indices, view, kNone)) fill_indices(*mesh, document_.accessors[primitive.indices], strip);
    for (const auto& [semantic, id] : extension["attributes"].items()) {
      if (log_.error_count() != errors) return;
      const auto found = primitive.attributes.find(semantic);
      if (found == primitive.attributes.end()) return fail(semantic + " is no attribute of the primitive");
      const auto attribute = static_cast<std::uint32_t>(id.get<double>());
      if (claim(found->second, view, attribute))
        fill_attribute(*mesh, attribute, semantic, document_.accessors[found->second]);
    }
  }

 private:
  /// Decodes a stream only once, even if several primitives share it.
  std::shared_ptr<const draco::Mesh> mesh_of(std::uint32_t view) {
    if (view >= document_.buffer_views.size()) {
      log_.report(
          Rule::reference, pointer(place_, "bufferView"),
          "index " + std::to_string(view) + " of " + std::to_string(document_.buffer_views.size()) + " entries");
      return nullptr;
    }
    auto& known = meshes_[view];
    if (known != nullptr) return known;
    const gltf::Bytes stream = document_.buffer_views[view].bytes;
    const auto size = probe_draco(stream);
    if (!size) {
      fail(size.error());
      return nullptr;
    }
    if (!budget_.take(12 * std::uint64_t{size->faces} + 32 * std::uint64_t{size->vertices})) {
      over_budget();
      return nullptr;
    }
    auto mesh = decode_draco_stream(stream);
    if (!mesh) {
      fail(mesh.error());
      return nullptr;
    }
    return known = *mesh;
  }

  /// Finds the accessor to fill for an attribute (or the faces) of a stream. If primitives with different streams share
  /// an accessor, the first stream fills it and each other stream gets a copy.
  /// in,out  named  accessor of the primitive; replaced by the one to fill
  /// out     false if the accessor already holds these elements
  bool claim(int& named, std::uint32_t view, std::uint32_t attribute) {
    const auto accessor = static_cast<std::uint32_t>(named);
    const auto [known, is_new] = filled_.try_emplace({accessor, view, attribute}, accessor);
    if (is_new && !taken_.insert(accessor).second) {
      known->second = static_cast<std::uint32_t>(document_.accessors.size());
      document_.accessors.push_back(gltf::Accessor(document_.accessors[accessor]));
    }
    named = static_cast<int>(known->second);
    return is_new;
  }

  /// Takes the element count from the stream. Encoders drop degenerate faces and merge vertices, and some write the old
  /// counts into accessors.
  void take_count(std::uint64_t count, const char* what, gltf::Accessor& accessor) {
    if (accessor.count == count) return;
    log_.report(Rule::draco_count, place_,
                "the stream has " + std::to_string(count) + " " + what + ", the accessor says " +
                    std::to_string(accessor.count) + "; those of the stream are used");
    accessor.count = count;
  }

  void fill_indices(const draco::Mesh& mesh, gltf::Accessor& accessor, bool strip) {
    const std::uint64_t count = 3 * std::uint64_t{mesh.num_faces()};
    if (strip)
      accessor.count = count;
    else
      take_count(count, "indices", accessor);
    std::vector<std::byte> bytes;
    if (!allocate(4 * accessor.count, bytes)) return;
    std::byte* to = bytes.data();
    for (std::uint32_t f = 0; f < mesh.num_faces(); ++f)
      for (int k = 0; k < 3; ++k, to += 4) {
        const std::uint32_t index = mesh.face(draco::FaceIndex(f))[static_cast<std::size_t>(k)].value();
        if (index >= mesh.num_points()) return fail("a face of the Draco stream leaves its vertices");
        std::memcpy(to, &index, 4);
      }
    accessor.component_type = gltf::ComponentType::u32;
    accessor.type = gltf::ElementType::scalar;
    attach(std::move(bytes), accessor);
  }

  void fill_attribute(const draco::Mesh& mesh, std::uint32_t id, const std::string& semantic,
                      gltf::Accessor& accessor) {
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(id);
    if (attribute == nullptr)
      return fail("the Draco stream has no attribute " + std::to_string(id) + " for " + semantic);
    if (attribute->data_type() == draco::DT_BOOL)  // bool data may hold arbitrary bytes
      return fail(semantic + " holds truth values in the Draco stream");
    const ElementLayout layout = element_layout(accessor);
    if (layout.columns != 1 || attribute->num_components() != layout.rows)
      return fail(semantic + " has " + std::to_string(attribute->num_components()) + " components in the Draco stream");
    take_count(mesh.num_points(), ("vertices for " + semantic).c_str(), accessor);
    std::vector<std::byte> bytes;
    if (!allocate(accessor.count * layout.element_bytes, bytes)) return;
    if (!copy_values(accessor.component_type, mesh, *attribute, bytes))
      return fail(semantic + " does not fit the accessor's type");
    attach(std::move(bytes), accessor);
  }

  bool allocate(std::uint64_t size, std::vector<std::byte>& bytes) {
    if (!budget_.take(size)) {
      over_budget();
      return false;
    }
    bytes.resize(static_cast<std::size_t>(size));
    return true;
  }

  void attach(std::vector<std::byte> bytes, gltf::Accessor& accessor) {
    document_.storage.push_back(std::move(bytes));
    gltf::BufferView view;
    view.bytes = document_.storage.back();
    view.byte_length = view.bytes.size();
    accessor.buffer_view = static_cast<std::uint32_t>(document_.buffer_views.size());
    accessor.byte_offset = 0;
    document_.buffer_views.push_back(std::move(view));
  }

  void fail(const std::string& detail) { log_.report(Rule::decode_failed, place_, detail); }
  void over_budget() {
    log_.report(Rule::memory_budget, place_, "decoding would take more memory than a file of this size may");
  }

  gltf::Document& document_;
  DecodeBudget& budget_;
  IssueLog& log_;
  std::string place_;
  std::map<std::uint32_t, std::shared_ptr<const draco::Mesh>> meshes_;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t>
      filled_;                     ///< {named accessor, view, attribute} -> filled accessor
  std::set<std::uint32_t> taken_;  ///< accessors used so far
};

}  // namespace

void decode_draco(gltf::Document& document, DecodeBudget& budget, IssueLog& log) {
  DracoDecoder decoder(document, budget, log);
  for (std::size_t m = 0; m < document.meshes.size(); ++m)
    for (std::size_t p = 0; p < document.meshes[m].primitives.size(); ++p) {
      auto& primitive = document.meshes[m].primitives[p];
      if (!primitive.extensions.is_object() || !primitive.extensions.contains(kDraco)) continue;
      const std::size_t errors = log.error_count();
      const std::string place = pointer("meshes", m, "primitives", p);
      decoder.decode(primitive, place);
      if (log.error_count() == errors)
        mend_decoded(document, primitive, primitive.extensions[kDraco]["attributes"], place, log);
      forget_bounds(document, primitive);
    }
}

}  // namespace sinew
