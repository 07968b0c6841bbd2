//VTK::System::Dec
//VTK::Output::Dec
uniform samplerCube brdfRadianceMap;
uniform float brdfLevel;  // mip level: 0 sharp
uniform float brdfGain;   // factor on the radiance
in vec3 ray;
void main()
{
  gl_FragData[0] = vec4(brdfGain * textureLod(brdfRadianceMap, ray, brdfLevel).rgb, 1.0);
}
