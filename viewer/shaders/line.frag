#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
#include "encode.glsl"

layout(location = 0) in vec4 line_color;   // sRGB

layout(location = 0) out vec4 shown;

void main() { shown = vec4(displayed_data(line_color.rgb), line_color.a); }
