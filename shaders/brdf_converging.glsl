// Environment light without filtering: every point draws one direction from the map's own density and one from the
// material's terms, weighted by the balance heuristic (E. Veach, "Robust Monte Carlo Methods for Light Transport
// Simulation" (1997), equation 9.8; E. Veach and L. Guibas 1995, doi 10.1145/218380.218498), so that each counts
// f cos(theta) L / (p_light + p_material). A frame is the mean of some points of one replicate of the sequence.
uniform mat3 brdfViewToEnvironment;  // rotation from view coordinates to those of the map
uniform int brdfSeed;                // of the replicate
uniform int brdfFirst;               // number of the frame's first point in its replicate
uniform int brdfCount;               // points of the frame
uniform int brdfRandom;              // 1: independent random points instead of a sequence
uniform float brdfShares[BRDF_TERMS];  // of the draws that each term gets; sum 1

vec3 brdfMaterialSample(vec3 wo, vec2 u);
float brdfMaterialPdf(vec3 wi, vec3 wo);
vec3 brdfValue(vec3 wi, vec3 wo);

vec4 brdfPoint4(uint i, uvec2 light, uvec2 material)
{
  if (brdfRandom != 0)
  {
    return vec4(brdfRandomPoint(i, light), brdfRandomPoint(i, material));
  }
  return vec4(brdfSobolPoint(i, light), brdfSobolPoint(i, material));
}

vec3 brdfContribution(vec3 wi, vec3 wo, vec3 direction, float light)
{
  float together = light + brdfMaterialPdf(wi, wo);
#if defined(BRDF_SHADOWS) && BRDF_SHADOWS > 1
  wi.z *= brdfSeen(direction);
#endif
  return together > 0.0 ? brdfValue(wi, wo) * brdfLight(direction) * (wi.z / together) : vec3(0.0);
}

vec3 brdfEnvironment(vec3 wo, mat3 frame, uvec2 pixel)
{
  uvec2 light = brdfHash(pixel), material = brdfHash(light ^ uvec2(0x85ebca6bu, 0xc2b2ae35u));
  vec3 sum = vec3(0.0);
  for (int i = 0; i < brdfCount; ++i)
  {
    vec4 u = brdfPoint4(uint(brdfFirst + i), light, material);
    float density;
    vec3 direction = brdfLightSample(u.xy, density);
    vec3 wi = direction * frame;
    if (wi.z > 0.0)
      sum += brdfContribution(wi, wo, direction, density);
    wi = brdfMaterialSample(wo, u.zw);
    if (wi.z > 0.0)
    {
      direction = frame * wi;
      sum += brdfContribution(wi, wo, direction, brdfLightPdf(direction));
    }
  }
  return sum / float(brdfCount);
}
