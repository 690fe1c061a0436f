// SPDX-License-Identifier: MIT
// Features of the surface that a pipeline draws, as specialisation constants; PassPipelines::mesh sets them. They are no
// uniforms, because drivers that run on the CPU compile a shader again for each value of a uniform that it branches on.

layout(constant_id = 5) const int kNormals = 0;   // enum NormalSource: 0 none (points and lines), 1 of the faces, 2 of the vertices
layout(constant_id = 6) const bool kTangents = false;
layout(constant_id = 7) const bool kUnlit = false;
// The set of texture coordinates of each texture: 0 = no texture, 1 = TEXCOORD_0, 2 = TEXCOORD_1.
layout(constant_id = 8) const int kBaseColorSet = 0;
layout(constant_id = 9) const int kMetallicRoughnessSet = 0;
layout(constant_id = 10) const int kNormalSet = 0;
layout(constant_id = 11) const int kOcclusionSet = 0;
layout(constant_id = 12) const int kEmissiveSet = 0;

layout(constant_id = 24) const bool kSpecular = false;   // index of refraction or specular differ from the defaults
layout(constant_id = 25) const bool kClearcoat = false;
layout(constant_id = 26) const bool kSheen = false;
// Textures of the layers (upload_materials.h): 0 = no texture, else 1 + 2 * place + (1 for TEXCOORD_1).
layout(constant_id = 28) const int kSpecularTexture = 0;
layout(constant_id = 29) const int kSpecularColorTexture = 0;
layout(constant_id = 30) const int kClearcoatTexture = 0;
layout(constant_id = 31) const int kClearcoatRoughnessTexture = 0;
layout(constant_id = 32) const int kClearcoatNormalTexture = 0;
layout(constant_id = 33) const int kSheenColorTexture = 0;
layout(constant_id = 34) const int kSheenRoughnessTexture = 0;
layout(constant_id = 35) const int kTransmissionTexture = 0;
