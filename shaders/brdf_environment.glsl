// Environment light by filtered importance sampling: M. Colbert and J. Krivanek, "GPU-Based Importance Sampling", GPU
// Gems 3, chapter 20 (2007). Each sample drawn with density p (1/sr) out of n stands for the solid angle 1 / (n p) and
// reads the level whose texels come nearest to that size.
uniform sampler2D brdfRadiancePicture;  // W / (sr m^2) or relative, linear
uniform brdfMap brdfRadianceMap;
uniform sampler2D brdfDiffusePicture;   // irradiance / pi: brdf::EnvironmentMap::diffuseMap
uniform mat3 brdfViewToEnvironment;     // rotation from view coordinates to those of the maps
uniform int brdfSeed;                   // of the samples' noise
uniform float brdfFilter;               // factor on each sample's solid angle: 4^(level bias)

// Mean radiance over the solid angle 1 / density (of one sample among all) about a unit direction.
vec3 brdfRadiance(vec3 direction, float density)
{
  vec3 a = abs(direction);
  float norm = a.x + a.y + a.z;
  // Texels of the finest level in that solid angle: each has 4 norm^3 / size^2. Level k = round(log4(texels)), by the
  // exponent of 2 texels: two levels a factor of 4.
  float texels = brdfFilter * brdfRadianceMap.size * brdfRadianceMap.size / (4.0 * norm * norm * norm * density);
  int exponent = (floatBitsToInt(2.0 * max(texels, 1.0)) >> 23) - 127;
  float level = min(float(exponent >> 1), brdfRadianceMap.last);
  return brdfLookUp(brdfRadiancePicture, brdfRadianceMap, brdfProject(direction, norm), level);
}

// Light reflected by a white Lambertian facing `normal`: 128 columns around the vertical, rows from pole to pole.
vec3 brdfDiffuse(vec3 normal)
{
  float around = 0.5 + atan(normal.x, -normal.z) / 6.28318531;
  float down = 64.0 * acos(clamp(normal.y, -1.0, 1.0)) / 3.14159265;
  return textureLod(brdfDiffusePicture, vec2(around + 0.5 / 128.0, (down + 0.5) / 65.0), 0.0).rgb;
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

// Point i of n of the lattice (i / n, i / golden ratio) in [0, 1)^2 (the Fibonacci lattice made for any n), shifted on the
// torus by random words, the first coordinate inside its interval of 1 / n only (Cranley and Patterson 1976): every
// interval of the first coordinate, which samplers turn into the distance from the lobe's axis, has its sample.
vec2 brdfPoint(int i, int n, uvec2 shift)
{
  vec2 offset = vec2(uvec2(shift.x, shift.y + uint(i) * 2654435769u) >> 8u) * (1.0 / 16777216.0);
  return vec2(min((float(i) + offset.x) / float(n), 0.99999994), offset.y);
}
