// SPDX-License-Identifier: MIT
// Share of the light around the mirror direction that surroundings let through.
// eq   light arrives in a cone around the bent normal b, of which access is the share weighted by the cosine to the normal n:
//      cos^2 = 1 - access / (b.n). The reflection is a cone about the mirror direction with cos = 10^(-roughness^2 - 0.1):
//      wider than the lobe, since the edge of the visible cone is not sharp. Their overlap (Oat and Sander, "Ambient
//      Aperture Lighting", 2007), as part of that with the half sphere about n; rough mirrors gather light from all of it:
//      mix(this, access, roughness^2)

// Area that two circles on a sphere share, of 2 pi.
// in   cosines of the radii, the radii and the distance of the middles, as angles
float overlap(vec2 cosines, vec2 radii, float between) {
  float share = clamp((radii.x + radii.y - between) / max(2.0 * min(radii.x, radii.y), 1e-4), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share) * (1.0 - max(cosines.x, cosines.y));
}

// in   access, bend  of ambient_access()
float mirrored_access(float access, vec2 bend, vec3 n, vec3 to_viewer, float roughness) {
  if (!kBent) return access;
  vec3 bent = bent_normal(n, bend), mirror = reflect(-to_viewer, n);
  float rough2 = roughness * roughness;
  float cos_lobe = exp2(-3.3219281 * (rough2 + 0.1));   // 2^3.3219281 = 10
  float cos_visible = sqrt(clamp(1.0 - access / max(dot(bent, n), 0.01), 0.0, 1.0));
  vec2 angles = acos(vec2(cos_visible, cos_lobe)), between = acos(clamp(vec2(dot(mirror, bent), dot(mirror, n)), -1.0, 1.0));
  float seen = overlap(vec2(cos_visible, cos_lobe), angles, between.x);
  float most = overlap(vec2(0.0, cos_lobe), vec2(0.5 * kPi, angles.y), between.y);
  return mix(min(seen / max(most, 1e-6), 1.0), access, rough2);
}

// What the hidden part of the reflection shows: surroundings that have the colour of the surface and get as much ambient
// light, as a share of the ambient light of the surface.
// in   mirrored  of mirrored_access()
vec3 mirrored_surroundings(float access, float mirrored, vec3 color) {
  return kBent ? access * (1.0 - mirrored) * color : vec3(0.0);
}
