#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Alpha test for 4x multisampling: keeps a number of samples in proportion to the covered part of the pixel, assuming
// linear alpha.
// eq   covered = (alpha - cutoff) / |change of alpha over the pixel| + 1/2
#include "frame_uniforms.glsl"
#include "material.glsl"

layout(location = 3) in vec4 texcoords;
layout(location = 4) in vec4 vertex_color;

const int kKept[5] = int[](0, 1, 9, 11, 15);   // sample masks for 0 to 4 kept samples; opposite samples first

void main() {
  float alpha = base_color_at(texcoords, vertex_color).a;
  float covered = clamp((alpha - material.alpha_cutoff + 1e-6) / max(fwidth(alpha), 1e-6) + 0.5, 0.0, 1.0);
  gl_SampleMask[0] = kKept[int(covered * 4.0 + 0.5)];
}
