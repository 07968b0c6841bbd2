// Environment light by filtered importance sampling: M. Colbert and J. Krivanek, "GPU-Based Importance Sampling", GPU
// Gems 3, chapter 20 (2007). Each sample drawn with density p (1/sr) out of n stands for the solid angle 1 / (n p) and
// reads the level whose texels come nearest to that size.
uniform sampler2D brdfRadiancePicture;  // W / (sr m^2) or relative, linear
uniform brdfMap brdfRadianceMap;
uniform usamplerBuffer brdfFootprints;  // the same, packed: brdf::OctahedralMap::Footprints
uniform float brdfFootprintUnit;
uniform sampler2D brdfDiffusePicture;   // irradiance / pi: brdf::EnvironmentMap::diffuseMap
uniform mat3 brdfViewToEnvironment;     // rotation from view coordinates to those of the maps
uniform int brdfSeed;                   // of the samples' noise
uniform float brdfFilter;               // factor on each sample's solid angle: 4^(level bias)

// The uniforms of every sample, read once a fragment: software devices fetch and convert one anew at each use.
float brdfSide = brdfRadianceMap.size;
int brdfSideBits = floatBitsToInt(brdfSide);
int brdfRow = int(brdfSide) + 1;
int brdfLastLevel = int(brdfRadianceMap.last);
vec3 brdfUnitOfWords = brdfFootprintUnit * vec3(1.0, 1.0 / 512.0, 1.0 / 262144.0);  // by each channel's lowest bit
// Texels of the finest level in a steradian at |x| + |y| + |z| = 1, twice, and one of 4^(level bias).
float brdfTexels = 0.5 * brdfFilter * brdfSide * brdfSide;

// Four words of brdf::OctahedralMap::Footprints mixed by their weights, in brdfUnitOfWords.
vec3 brdfUnpack(uvec4 words, vec4 weights)
{
  vec4 scales = weights * intBitsToFloat(ivec4((words >> 27u) + 96u) << 23);
  return vec3(dot(scales, vec4(ivec4(words & 0x1ffu))), dot(scales, vec4(ivec4(words & 0x3fe00u))),
              dot(scales, vec4(ivec4(words & 0x7fc0000u))));
}

// Mean radiance over `solidAngle` (sr) about a direction of length l; `solidAngle` is given times l^3.
vec3 brdfRadiance(vec3 direction, float solidAngle)
{
  vec3 a = abs(direction);
  float inverse = 1.0 / (a.x + a.y + a.z);
  // A texel has 4 / (inverse^3 size^2). Level k = round(log4(texels)), by the exponent of 2 texels: two levels a factor
  // of 4.
  float texels = brdfTexels * (inverse * inverse) * (inverse * solidAngle);
  int level = min(((floatBitsToInt(max(texels, 2.0)) >> 23) - 127) >> 1, brdfLastLevel);
  float n = intBitsToFloat(brdfSideBits - (level << 23));
  vec2 place = brdfProject(direction, inverse) * n + 0.5;
  ivec2 texel = ivec2(place);
  vec2 after = place - vec2(texel), before = 1.0 - after;
  int row = 2 * (brdfRow - 1 - int(n)) + level + texel.y;
  vec3 radiance = brdfUnitOfWords * brdfUnpack(texelFetch(brdfFootprints, row * brdfRow + texel.x),
    vec4(before.x * before.y, after.x * before.y, before.x * after.y, after.x * after.y));
#if defined(BRDF_SHADOWS) && BRDF_SHADOWS > 1
  radiance *= brdfSeen(direction);
#endif
  return radiance;
}

vec2 brdfUnit(uvec2 word)
{
  return vec2(ivec2(word >> 8u)) * (1.0 / 16777216.0);
}

// Point i of n = 1 / inverse of the lattice (i / n, i / golden ratio) in [0, 1)^2 (the Fibonacci lattice made for any n), shifted on the
// torus by random words, the first coordinate inside its interval of 1 / n only (Cranley and Patterson 1976): every
// interval of the first coordinate, which samplers turn into the distance from the lobe's axis, has its sample.
vec2 brdfPoint(int i, float inverse, uvec2 shift)
{
  vec2 offset = brdfUnit(uvec2(shift.x, shift.y + uint(i) * 2654435769u));
  return vec2(min((float(i) + offset.x) * inverse, 0.99999994), offset.y);
}

// Light reflected by a white Lambertian facing `normal`, a direction of the map. A picture of it holds 128 columns around
// the vertical, rows from pole to pole. Shadows take from it the share of the cells that are not seen, each with its mean
// radiance at its middle.
vec3 brdfDiffuse(vec3 normal)
{
  float around = 0.5 + atan(normal.x, -normal.z) / 6.28318531;
  float down = 64.0 * acos(clamp(normal.y, -1.0, 1.0)) / 3.14159265;
  vec3 diffuse = textureLod(brdfDiffusePicture, vec2(around + 0.5 / 128.0, (down + 0.5) / 65.0), 0.0).rgb;
#if defined(BRDF_SHADOWS) && BRDF_SHADOWS > 1
  float level = clamp(log2(brdfRadianceMap.size / float(brdfShadowCells)), 0.0, brdfRadianceMap.last);
  vec3 seen = vec3(0.0), all = vec3(0.0);
  for (int row = 0; row < brdfShadowCells; ++row)
  {
    for (int column = 0; column < brdfShadowCells; ++column)
    {
      vec2 place = (vec2(column, row) + 0.5) / float(brdfShadowCells);
      vec2 p = 2.0 * place - 1.0;
      vec3 d = vec3(p.x, 1.0 - abs(p.x) - abs(p.y), p.y);
      if (d.y < 0.0)
      {
        d.xz = vec2(p.x < 0.0 ? abs(p.y) - 1.0 : 1.0 - abs(p.y), p.y < 0.0 ? abs(p.x) - 1.0 : 1.0 - abs(p.x));
      }
      // |x| + |y| + |z| = 1: the cosine over the length d, and the cell's solid angle as 1 / d^3.
      float squared = dot(d, d);
      float weight = max(dot(d, normal), 0.0) / (squared * squared);
      if (weight > 0.0)
      {
        vec3 light = weight * brdfLookUp(brdfRadiancePicture, brdfRadianceMap, place, level);
        all += light;
        seen += light * brdfCellSeen(ivec2(column, row));
      }
    }
  }
  diffuse *= seen / max(all, vec3(1e-30));
#endif
  return diffuse;
}

// Four more numbers in [0, 1) for sample i: the sequence R4 (M. Roberts, 2018), shifted likewise.
vec4 brdfFour(int i, uvec2 shift)
{
  uvec4 words = shift.xyyx * uvec4(1u, 1u, 3u, 5u) + uint(i) * uvec4(3679390609u, 3152041523u, 2700274805u, 2313257605u);
  return vec4(ivec4(words >> 8u)) * (1.0 / 16777216.0);
}
