// Environment light by filtered importance sampling: M. Colbert and J. Krivanek, "GPU-Based Importance Sampling", GPU
// Gems 3, chapter 20 (2007). Each sample drawn with density p (1/sr) out of n stands for the solid angle 1 / (n p) and
// reads the mip level whose texels are of that size.
uniform samplerCube brdfRadianceMap;    // W / (sr m^2) or relative, linear; levels are means over solid angle
uniform samplerCube brdfDiffuseMap;     // irradiance / pi
uniform mat3 brdfViewToEnvironment;     // rotation from view coordinates to those of the maps
uniform float brdfRadianceMapSize;      // texels along a side of a face
uniform float brdfLevelBias;            // levels added: 1 doubles the filter's width

// Mean radiance over the solid angle 1 / density (of one sample among all) about a direction.
vec3 brdfRadiance(vec3 direction, float density)
{
  // A texel of a cube map covers 4 m^3 / size^2 steradian, where m is the largest component of the unit direction.
  vec3 a = abs(direction);
  float m = max(a.x, max(a.y, a.z));
  float texels = brdfRadianceMapSize * brdfRadianceMapSize / (4.0 * m * m * m * density);
  return textureLod(brdfRadianceMap, direction, max(0.5 * log2(texels) + brdfLevelBias, 0.0)).rgb;
}

// Two independent random words from two words: M. Jarzynski and M. Olano, "Hash Functions for GPU Rendering", JCGT 9(3),
// 2020, pcg2d.
uvec2 brdfHash(uvec2 v)
{
  v = v * 1664525u + 1013904223u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  return v;
}

// Point i of the R2 sequence (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018) in [0, 1)^2,
// shifted on the torus by a random word (Cranley and Patterson 1976). Integer arithmetic: exact for any i.
vec2 brdfPoint(int i, uvec2 shift)
{
  uvec2 x = shift + uint(i) * uvec2(3242174889u, 2447445414u);
  return vec2(x >> 8u) * (1.0 / 16777216.0);
}
