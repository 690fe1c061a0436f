// SPDX-License-Identifier: MIT
// Specular visibility: the fraction of light around the mirror direction that is not occluded.
// eq   Light arrives in a cone around the bent normal b, with cos^2 = 1 - visibility / (b.n) about the normal n. The
//      reflection is a cone about the mirror direction with cos = 10^(-roughness^2 - 0.1), wider than the lobe because
//      the edge of the visible cone is not sharp. Result: the overlap of both cones (Oat and Sander, "Ambient Aperture
//      Lighting", 2007), relative to the overlap with the hemisphere about n. Rough mirrors gather light from the whole
//      hemisphere: mix(result, visibility, roughness^2)

// Overlap area of two spherical caps, relative to 2 pi.
// in   cosines of the cap radii;   radii, between  angles: cap radii, distance of the centers
float overlap(vec2 cosines, vec2 radii, float between) {
  float share = clamp((radii.x + radii.y - between) / max(2.0 * min(radii.x, radii.y), 1e-4), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share) * (1.0 - max(cosines.x, cosines.y));
}

// in   visibility, bend  results of ambient_visibility()
float mirrored_visibility(float visibility, vec2 bend, vec3 n, vec3 to_viewer, float roughness) {
  if (!kBent) return visibility;
  vec3 bent = bent_normal(n, bend), mirror = reflect(-to_viewer, n);
  float rough2 = roughness * roughness;
  float cos_lobe = exp2(-3.3219281 * (rough2 + 0.1));   // 2^3.3219281 = 10
  float cos_visible = sqrt(clamp(1.0 - visibility / max(dot(bent, n), 0.01), 0.0, 1.0));
  vec2 angles = acos(vec2(cos_visible, cos_lobe)), between = acos(clamp(vec2(dot(mirror, bent), dot(mirror, n)), -1.0, 1.0));
  float seen = overlap(vec2(cos_visible, cos_lobe), angles, between.x);
  float most = overlap(vec2(0.0, cos_lobe), vec2(0.5 * kPi, angles.y), between.y);
  return mix(min(seen / max(most, 1e-6), 1.0), visibility, rough2);
}

// Light in the hidden part of the reflection, relative to the surface's ambient light. Assumes occluders with the
// surface's colour and ambient visibility.
// in   mirrored  result of mirrored_visibility()
vec3 mirrored_surroundings(float visibility, float mirrored, vec3 color) {
  return kBent ? visibility * (1.0 - mirrored) * color : vec3(0.0);
}
