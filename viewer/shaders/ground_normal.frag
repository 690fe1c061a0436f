#version 450
// SPDX-License-Identifier: MIT
// The ground in the prepass.

layout(location = 2) flat in vec3 normal;

layout(location = 0) out vec4 view_normal;

void main() { view_normal = vec4(normal, 1.0); }
