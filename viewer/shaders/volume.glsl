// SPDX-License-Identifier: MIT
// KHR_materials_volume: light from behind is refracted at the surface and absorbed on its way through the thickness.

// Light that comes through the surface.
struct Passed {
  vec3 share;   // fraction that reaches the viewer
  float frost;  // roughness, 0 to 1
  vec3 exit;    // view-space point where the viewer's ray leaves the volume; without a volume, on the surface
};

// The length of the path through the volume: its thickness, scaled with the mesh.
float path_in_volume() {
  float thickness_m = material.thickness_m;
  if (kThicknessTexture != 0) thickness_m *= layer_texel(kThicknessTexture, 16, texcoords).g;
  vec3 a = draw.view_from_mesh[0].xyz, b = draw.view_from_mesh[1].xyz, c = draw.view_from_mesh[2].xyz;
  return thickness_m * pow(abs(dot(a, cross(b, c))), 1.0 / 3.0);
}

// eq   Snell's law, and Beer's: exp(-absorption * path)
void pass_volume(vec3 n, vec3 to_viewer, inout Passed passed) {
  if (!kVolume) return;
  float path_m = path_in_volume();
  passed.exit += refract(-to_viewer, n, material.inverse_ior) * path_m;
  passed.share *= exp(-material.absorption_per_m * path_m);
}
