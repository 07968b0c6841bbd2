// From a fragment to outgoing radiance. Calls what the assembler writes for the material:
//   vec3 brdfValue(vec3 wi, vec3 wo)                              f_r by channel, 1/sr
//   vec3 brdfEnvironment(vec3 wo, mat3 frame, uvec2 pixel)        radiance reflected from the environment, where
//                                                                 BRDF_ENVIRONMENT is defined
uniform int brdfLightCount;
uniform vec4 brdfLightPosition[8];  // view coordinates; w = 0: direction to the light, w = 1: place of a point light
uniform vec3 brdfLightPower[8];     // irradiance across the beam (w = 0), or radiant intensity (w = 1)
uniform float brdfGain;             // factor on the radiance
uniform int brdfEncoded;            // 1: sRGB-encoded for an 8-bit window

// Local frame: columns tangent, bitangent, normal (unit, right-handed). The tangent is made perpendicular; a zero one is
// replaced (T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017).
mat3 brdfFrame(vec3 n, vec3 tangent)
{
  vec3 t = tangent - dot(tangent, n) * n;
  if (dot(t, t) <= 1e-12 * dot(tangent, tangent))
  {
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    t = vec3(1.0 + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
  }
  t = normalize(t);
  return mat3(t, cross(n, t), n);
}

vec3 brdfReflected(vec3 position, vec3 viewer, vec3 normal, vec3 tangent)
{
  // Interpolated normals can turn away from the viewer at a silhouette: tilt them back to 89.94 degrees.
  const float grazing = 1e-3;
  float facing = dot(normal, viewer);
  if (facing < grazing)
  {
    normal = normalize(normal + (grazing - facing) * viewer);
  }
  mat3 frame = brdfFrame(normal, tangent);
  vec3 wo = viewer * frame;
  vec3 radiance = vec3(0.0);
#ifdef BRDF_ENVIRONMENT
  radiance = brdfEnvironment(wo, brdfViewToEnvironment * frame, 
    uvec2(gl_FragCoord.xy) + uint(brdfSeed) * 65536u);
#endif
  for (int i = 0; i < brdfLightCount; ++i)
  {
    vec3 toLight = brdfLightPosition[i].xyz - brdfLightPosition[i].w * position;
    float squared = dot(toLight, toLight);
    vec3 wi = toLight * inversesqrt(squared) * frame;
#ifdef BRDF_SHADOWS
    wi.z = brdfLit(i) ? wi.z : 0.0;
#endif
    if (wi.z > 0.0)
    {
      float falloff = brdfLightPosition[i].w > 0.0 ? 1.0 / squared : 1.0;
      radiance += brdfValue(wi, wo) * brdfLightPower[i] * (wi.z * falloff);
    }
  }
  radiance *= brdfGain;
  if (brdfEncoded != 0)  // IEC 61966-2-1
  {
    vec3 c = clamp(radiance, 0.0, 1.0);
    radiance = mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
  }
  return radiance;
}
