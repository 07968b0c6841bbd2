// What light reaches the pixel: a brdf::ShadowMask, cast on the CPU. BRDF_SHADOWS is 1 for the lights besides the
// environment, 2 for the environment too.
uniform usampler2D brdfShadowMask;  // layers above each other
uniform int brdfShadowRows;         // pixels of a layer's height
uniform int brdfShadowCells;        // of the environment, a side

bool brdfLit(int light)
{
  return (texelFetch(brdfShadowMask, ivec2(gl_FragCoord.xy), 0).x >> uint(light) & 1u) != 0u;
}

#if BRDF_SHADOWS > 1
vec2 brdfProject(vec3 direction, float inverse);

// 1 where the environment is seen in a cell, else 0.
float brdfCellSeen(ivec2 at)
{
  int cell = at.y * brdfShadowCells + at.x;
  uvec4 words = texelFetch(brdfShadowMask, ivec2(gl_FragCoord.xy) + ivec2(0, (1 + cell / 128) * brdfShadowRows), 0);
  return float(words[cell / 32 % 4] >> uint(cell % 32) & 1u);
}

// The same in a direction of the environment's map.
float brdfSeen(vec3 direction)
{
  vec2 place = brdfProject(direction, 1.0 / (abs(direction.x) + abs(direction.y) + abs(direction.z)));
  return brdfCellSeen(min(ivec2(place * float(brdfShadowCells)), brdfShadowCells - 1));
}
#endif
