// SPDX-License-Identifier: MIT
// Surface features as specialisation constants, set by PassPipelines::mesh. They are not uniforms, because software
// drivers recompile a shader for each value of a uniform that it branches on.

layout(constant_id = 5) const int kNormals = 0;   // enum NormalSource: 0 none (points and lines), 1 faces, 2 vertices
layout(constant_id = 6) const bool kTangents = false;
layout(constant_id = 7) const bool kUnlit = false;
// Texture coordinate set of each texture: 0 = no texture, 1 = TEXCOORD_0, 2 = TEXCOORD_1.
layout(constant_id = 8) const int kBaseColorSet = 0;
layout(constant_id = 9) const int kMetallicRoughnessSet = 0;
layout(constant_id = 10) const int kNormalSet = 0;
layout(constant_id = 11) const int kOcclusionSet = 0;
layout(constant_id = 12) const int kEmissiveSet = 0;

layout(constant_id = 24) const bool kSpecular = false;   // index of refraction or specular differs from the default
layout(constant_id = 25) const bool kClearcoat = false;
layout(constant_id = 26) const bool kSheen = false;
layout(constant_id = 31) const bool kGlossiness = false; // channel A of the specular colour scales 1 - roughness
layout(constant_id = 30) const bool kVolume = false;     // light from behind is refracted and absorbed
// Layer textures (upload_materials.h): 0 = no texture, else 1 + 2 * place + (1 for TEXCOORD_1).
layout(constant_id = 40) const int kSpecularTexture = 0;
layout(constant_id = 41) const int kSpecularColorTexture = 0;
layout(constant_id = 42) const int kClearcoatTexture = 0;
layout(constant_id = 43) const int kClearcoatRoughnessTexture = 0;
layout(constant_id = 44) const int kClearcoatNormalTexture = 0;
layout(constant_id = 45) const int kSheenColorTexture = 0;
layout(constant_id = 46) const int kSheenRoughnessTexture = 0;
layout(constant_id = 47) const int kTransmissionTexture = 0;
layout(constant_id = 48) const int kIridescenceTexture = 0;
layout(constant_id = 49) const int kFilmThicknessTexture = 0;
layout(constant_id = 50) const int kAnisotropyTexture = 0;
layout(constant_id = 51) const int kThicknessTexture = 0;
