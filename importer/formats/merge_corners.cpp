// SPDX-License-Identifier: MIT
#include "importer/formats/merge_corners.h"

#include <string>
#include <unordered_map>
#include <utility>

namespace sinew::formats {
namespace {

template <class T>
void append(std::string& key, const T& value) {
  key.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// Everything that a corner says, as bytes.
std::vector<std::string> keys_of(const aiMesh& mesh) {
  std::vector<std::string> keys(mesh.mNumVertices);
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    std::string& key = keys[v];
    append(key, mesh.mVertices[v]);
    if (mesh.HasNormals()) append(key, mesh.mNormals[v]);
    if (mesh.HasVertexColors(0)) append(key, mesh.mColors[0][v]);
    for (unsigned n = 0; n < AI_MAX_NUMBER_OF_TEXTURECOORDS; ++n)
      if (mesh.HasTextureCoords(n)) append(key, mesh.mTextureCoords[n][v]);
    for (unsigned t = 0; t < mesh.mNumAnimMeshes; ++t) {
      const aiAnimMesh& target = *mesh.mAnimMeshes[t];
      if (v >= target.mNumVertices) continue;
      if (target.HasPositions()) append(key, target.mVertices[v]);
      if (target.HasNormals()) append(key, target.mNormals[v]);
    }
  }
  for (unsigned b = 0; b < mesh.mNumBones; ++b)
    for (unsigned i = 0; i < mesh.mBones[b]->mNumWeights; ++i)
      if (const aiVertexWeight& weight = mesh.mBones[b]->mWeights[i]; weight.mVertexId < mesh.mNumVertices) {
        append(keys[weight.mVertexId], b);
        append(keys[weight.mVertexId], weight.mWeight);
      }
  return keys;
}

}  // namespace

MergedCorners merge_corners(const aiMesh& mesh) {
  MergedCorners out;
  std::unordered_map<std::string, std::uint32_t> vertex_of_key;
  unsigned corner = 0;
  for (std::string& key : keys_of(mesh)) {
    const auto next = static_cast<std::uint32_t>(out.corner.size());
    const auto [found, is_new] = vertex_of_key.try_emplace(std::move(key), next);
    if (is_new) out.corner.push_back(corner);
    out.vertex_of_corner.push_back(found->second);
    ++corner;
  }
  return out;
}

}  // namespace sinew::formats
