// Look-ups in an octahedral map with its levels in one picture: see libbrdf/io/OctahedralMap.h.
struct brdfMap
{
  float size;   // texels along a side of the finest level, a power of two
  float last;   // number of the coarsest level
  vec2 texel;   // 1 / size of the picture
};

// Position on the finest level's square, [0, 1]^2, of a direction, `inverse` being 1 / (|x| + |y| + |z|).
vec2 brdfProject(vec3 direction, float inverse)
{
  vec2 p = direction.xz * inverse;
  if (direction.y < 0.0)
  {
    vec2 folded = 1.0 - abs(p.yx);
    p = vec2(p.x < 0.0 ? -folded.x : folded.x, p.y < 0.0 ? -folded.y : folded.y);
  }
  return 0.5 * p + 0.5;
}

// Bilinear look-up in one level.
vec3 brdfLookUp(sampler2D picture, brdfMap map, vec2 position, float level)
{
  float n = map.size * exp2(-level);
  vec2 corner = level > 0.0 ? vec2(map.size + 2.0, map.size - 2.0 * n + 2.0 * (level - 1.0)) : vec2(0.0);
  return textureLod(picture, (corner + position * n + 1.0) * map.texel, 0.0).rgb;
}
