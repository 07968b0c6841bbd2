//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : enable
//VTK::Output::Dec
//BRDF::Map::Dec
uniform sampler2D brdfRadiancePicture;
uniform brdfMap brdfRadianceMap;
uniform float brdfLevel;  // 0 sharp; between two levels both are mixed
uniform float brdfGain;   // factor on the radiance
in vec3 ray;
void main()
{
#ifdef BRDF_UNFILTERED
  gl_FragData[0] = vec4(brdfGain * brdfLight(normalize(ray)), 1.0);
#else
  float inverse = 1.0 / (abs(ray.x) + abs(ray.y) + abs(ray.z));
  vec2 position = brdfProject(ray, inverse);
  float level = clamp(brdfLevel, 0.0, brdfRadianceMap.last);
  vec3 finer = brdfLookUp(brdfRadiancePicture, brdfRadianceMap, position, floor(level));
  vec3 coarser = brdfLookUp(brdfRadiancePicture, brdfRadianceMap, position, ceil(level));
  gl_FragData[0] = vec4(brdfGain * mix(finer, coarser, fract(level)), 1.0);
#endif
}
