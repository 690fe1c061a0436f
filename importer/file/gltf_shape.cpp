// SPDX-License-Identifier: MIT
#include "importer/file/gltf_shape.h"

namespace sinew {
namespace {

using Kind = JsonKind;
constexpr double kMaxIndex = 2147483646.0;
constexpr double kMaxSize = 9007199254740991.0;  // 2^53 - 1
constexpr double kMaxFloat = 3.4028234663852886e38;

constexpr JsonValueShape kBool{.kind = Kind::boolean};
constexpr JsonValueShape kText{.kind = Kind::string};
constexpr JsonValueShape kNumber{.kind = Kind::number, .lower = -kMaxFloat, .upper = kMaxFloat};
constexpr JsonValueShape kDouble{.kind = Kind::number};
constexpr JsonValueShape kIndex{.kind = Kind::integer, .lower = 0, .upper = kMaxIndex};
constexpr JsonValueShape kSize{.kind = Kind::integer, .lower = 0, .upper = kMaxSize};
constexpr JsonValueShape kNumbers{.kind = Kind::array, .element = &kNumber};
constexpr JsonValueShape kDoubles{.kind = Kind::array, .element = &kDouble};
constexpr JsonValueShape kIndices{.kind = Kind::array, .element = &kIndex};
constexpr JsonValueShape kTexts{.kind = Kind::array, .element = &kText};
constexpr JsonValueShape kVec3{.kind = Kind::array, .element = &kNumber, .length = 3};
constexpr JsonValueShape kVec4{.kind = Kind::array, .element = &kNumber, .length = 4};
constexpr JsonValueShape kMat4{.kind = Kind::array, .element = &kNumber, .length = 16};
constexpr JsonValueShape kIndexMap{.kind = Kind::index_map, .element = &kIndex};
constexpr JsonValueShape kIndexMaps{.kind = Kind::array, .element = &kIndexMap};

constexpr JsonProperty kExtensions{"extensions", {.kind = Kind::extensions}};
constexpr JsonProperty kName{"name", kText};

constexpr JsonProperty kAssetProperties[] = {
    {"version", kText, true}, {"minVersion", kText}, {"generator", kText}, {"copyright", kText}, kExtensions};
constexpr JsonObjectShape kAsset{kAssetProperties};

constexpr std::int64_t kComponentTypes[] = {5120, 5121, 5122, 5123, 5125, 5126};
constexpr std::int64_t kIndexTypes[] = {5121, 5123, 5125};
constexpr std::string_view kElementTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
constexpr JsonProperty kSparseIndicesProperties[] = {
    {"bufferView", kIndex, true},
    {"byteOffset", kSize},
    {"componentType", {.kind = Kind::integer, .numbers = kIndexTypes}, true}};
constexpr JsonObjectShape kSparseIndices{kSparseIndicesProperties};
constexpr JsonProperty kSparseValuesProperties[] = {{"bufferView", kIndex, true}, {"byteOffset", kSize}};
constexpr JsonObjectShape kSparseValues{kSparseValuesProperties};
constexpr JsonProperty kSparseProperties[] = {{"count", kIndex, true},
                                              {"indices", {.kind = Kind::object, .object = &kSparseIndices}, true},
                                              {"values", {.kind = Kind::object, .object = &kSparseValues}, true}};
constexpr JsonObjectShape kSparse{kSparseProperties};
constexpr JsonProperty kAccessorProperties[] = {
    {"bufferView", kIndex},
    {"byteOffset", kSize},
    {"componentType", {.kind = Kind::integer, .numbers = kComponentTypes}, true},
    {"normalized", kBool},
    {"count", kSize, true},
    {"type", {.kind = Kind::string, .words = kElementTypes}, true},
    {"max", kDoubles},
    {"min", kDoubles},
    {"sparse", {.kind = Kind::object, .object = &kSparse}},
    kExtensions};
constexpr JsonObjectShape kAccessor{kAccessorProperties};

constexpr JsonProperty kBufferProperties[] = {{"uri", kText}, {"byteLength", kSize, true}, kExtensions};
constexpr JsonObjectShape kBuffer{kBufferProperties};
constexpr JsonProperty kViewProperties[] = {
    {"buffer", kIndex, true}, {"byteOffset", kSize}, {"byteLength", kSize, true}, {"byteStride", kSize}, kExtensions};
constexpr JsonObjectShape kView{kViewProperties};

constexpr JsonProperty kPrimitiveProperties[] = {{"attributes", kIndexMap, true},
                                                 {"indices", kIndex},
                                                 {"material", kIndex},
                                                 {"mode", {.kind = Kind::integer, .lower = 0, .upper = 6}},
                                                 {"targets", kIndexMaps},
                                                 kExtensions};
constexpr JsonObjectShape kPrimitive{kPrimitiveProperties};
constexpr JsonValueShape kPrimitiveValue{.kind = Kind::object, .object = &kPrimitive};
constexpr JsonProperty kMeshProperties[] = {{"primitives", {.kind = Kind::array, .element = &kPrimitiveValue}, true},
                                            {"weights", kNumbers},
                                            kName,
                                            kExtensions};
constexpr JsonObjectShape kMesh{kMeshProperties};

constexpr JsonProperty kNodeProperties[] = {
    {"camera", kIndex},  {"children", kIndices}, {"skin", kIndex},       {"matrix", kMat4},     {"mesh", kIndex},
    {"rotation", kVec4}, {"scale", kVec3},       {"translation", kVec3}, {"weights", kNumbers}, kName,
    kExtensions};
constexpr JsonObjectShape kNode{kNodeProperties};
constexpr JsonProperty kSkinProperties[] = {
    {"inverseBindMatrices", kIndex}, {"skeleton", kIndex}, {"joints", kIndices, true}, kName, kExtensions};
constexpr JsonObjectShape kSkin{kSkinProperties};

constexpr JsonProperty kTargetProperties[] = {{"node", kIndex}, {"path", kText, true}, kExtensions};
constexpr JsonObjectShape kTarget{kTargetProperties};
constexpr JsonProperty kChannelProperties[] = {
    {"sampler", kIndex, true}, {"target", {.kind = Kind::object, .object = &kTarget}, true}, kExtensions};
constexpr JsonObjectShape kChannel{kChannelProperties};
constexpr JsonValueShape kChannelValue{.kind = Kind::object, .object = &kChannel};
constexpr JsonProperty kSamplerProperties[] = {
    {"input", kIndex, true}, {"interpolation", kText}, {"output", kIndex, true}, kExtensions};
constexpr JsonObjectShape kSampler{kSamplerProperties};
constexpr JsonValueShape kSamplerValue{.kind = Kind::object, .object = &kSampler};
constexpr JsonProperty kAnimationProperties[] = {{"channels", {.kind = Kind::array, .element = &kChannelValue}, true},
                                                 {"samplers", {.kind = Kind::array, .element = &kSamplerValue}, true},
                                                 kName,
                                                 kExtensions};
constexpr JsonObjectShape kAnimation{kAnimationProperties};

constexpr JsonProperty kTextureInfoProperties[] = {
    {"index", kIndex, true}, {"texCoord", kIndex}, {"scale", kNumber}, {"strength", kNumber}, kExtensions};
constexpr JsonObjectShape kTextureInfo{kTextureInfoProperties};
constexpr JsonValueShape kTextureUse{.kind = Kind::object, .object = &kTextureInfo};
constexpr JsonProperty kRoughnessProperties[] = {
    {"baseColorFactor", kVec4},   {"baseColorTexture", kTextureUse},         {"metallicFactor", kNumber},
    {"roughnessFactor", kNumber}, {"metallicRoughnessTexture", kTextureUse}, kExtensions};
constexpr JsonObjectShape kRoughness{kRoughnessProperties};
constexpr JsonProperty kMaterialProperties[] = {{"pbrMetallicRoughness", {.kind = Kind::object, .object = &kRoughness}},
                                                {"normalTexture", kTextureUse},
                                                {"occlusionTexture", kTextureUse},
                                                {"emissiveTexture", kTextureUse},
                                                {"emissiveFactor", kVec3},
                                                {"alphaMode", kText},
                                                {"alphaCutoff", kNumber},
                                                {"doubleSided", kBool},
                                                kName,
                                                kExtensions};
constexpr JsonObjectShape kMaterial{kMaterialProperties};
constexpr JsonProperty kTextureProperties[] = {{"sampler", kIndex}, {"source", kIndex}, kName, kExtensions};
constexpr JsonObjectShape kTexture{kTextureProperties};
constexpr JsonProperty kImageProperties[] = {
    {"uri", kText}, {"mimeType", kText}, {"bufferView", kIndex}, kName, kExtensions};
constexpr JsonObjectShape kImage{kImageProperties};
constexpr JsonProperty kTextureSamplerProperties[] = {
    {"magFilter", kIndex}, {"minFilter", kIndex}, {"wrapS", kIndex}, {"wrapT", kIndex}, kExtensions};
constexpr JsonObjectShape kTextureSampler{kTextureSamplerProperties};

constexpr JsonProperty kPerspectiveProperties[] = {
    {"aspectRatio", kNumber}, {"yfov", kNumber, true}, {"zfar", kNumber}, {"znear", kNumber, true}};
constexpr JsonObjectShape kPerspective{kPerspectiveProperties};
constexpr JsonProperty kOrthographicProperties[] = {
    {"xmag", kNumber, true}, {"ymag", kNumber, true}, {"zfar", kNumber, true}, {"znear", kNumber, true}};
constexpr JsonObjectShape kOrthographic{kOrthographicProperties};
constexpr std::string_view kCameraTypes[] = {"perspective", "orthographic"};
constexpr JsonProperty kCameraProperties[] = {{"type", {.kind = Kind::string, .words = kCameraTypes}, true},
                                              {"perspective", {.kind = Kind::object, .object = &kPerspective}},
                                              {"orthographic", {.kind = Kind::object, .object = &kOrthographic}},
                                              kName,
                                              kExtensions};
constexpr JsonObjectShape kCamera{kCameraProperties};
constexpr JsonProperty kSceneProperties[] = {{"nodes", kIndices}, kName, kExtensions};
constexpr JsonObjectShape kScene{kSceneProperties};

constexpr JsonValueShape kAccessorValue{.kind = Kind::object, .object = &kAccessor};
constexpr JsonValueShape kBufferValue{.kind = Kind::object, .object = &kBuffer};
constexpr JsonValueShape kViewValue{.kind = Kind::object, .object = &kView};
constexpr JsonValueShape kMeshValue{.kind = Kind::object, .object = &kMesh};
constexpr JsonValueShape kNodeValue{.kind = Kind::object, .object = &kNode};
constexpr JsonValueShape kSkinValue{.kind = Kind::object, .object = &kSkin};
constexpr JsonValueShape kAnimationValue{.kind = Kind::object, .object = &kAnimation};
constexpr JsonValueShape kMaterialValue{.kind = Kind::object, .object = &kMaterial};
constexpr JsonValueShape kTextureValue{.kind = Kind::object, .object = &kTexture};
constexpr JsonValueShape kImageValue{.kind = Kind::object, .object = &kImage};
constexpr JsonValueShape kTextureSamplerValue{.kind = Kind::object, .object = &kTextureSampler};
constexpr JsonValueShape kCameraValue{.kind = Kind::object, .object = &kCamera};
constexpr JsonValueShape kSceneValue{.kind = Kind::object, .object = &kScene};

constexpr JsonValueShape list_of(const JsonValueShape& element) { return {.kind = Kind::array, .element = &element}; }

constexpr JsonProperty kRootProperties[] = {{"asset", {.kind = Kind::object, .object = &kAsset}, true},
                                            {"extensionsUsed", kTexts},
                                            {"extensionsRequired", kTexts},
                                            {"accessors", list_of(kAccessorValue)},
                                            {"animations", list_of(kAnimationValue)},
                                            {"buffers", list_of(kBufferValue)},
                                            {"bufferViews", list_of(kViewValue)},
                                            {"cameras", list_of(kCameraValue)},
                                            {"images", list_of(kImageValue)},
                                            {"materials", list_of(kMaterialValue)},
                                            {"meshes", list_of(kMeshValue)},
                                            {"nodes", list_of(kNodeValue)},
                                            {"samplers", list_of(kTextureSamplerValue)},
                                            {"scene", kIndex},
                                            {"scenes", list_of(kSceneValue)},
                                            {"skins", list_of(kSkinValue)},
                                            {"textures", list_of(kTextureValue)},
                                            kExtensions};
constexpr JsonObjectShape kRoot{kRootProperties};
constexpr JsonValueShape kRootValue{.kind = Kind::object, .object = &kRoot};

}  // namespace

const JsonValueShape& gltf_shape() { return kRootValue; }

}  // namespace sinew
