//VTK::System::Dec
//VTK::Output::Dec
// Closes the depth buffer (0, the near plane) where a pixel is not to be drawn again, and opens it (1) where it is.
uniform sampler2D brdfMask;
in vec3 ray;
void main()
{
  gl_FragDepth = texelFetch(brdfMask, ivec2(gl_FragCoord.xy), 0).r;
  gl_FragData[0] = vec4(ray, 1.0);  // colours are masked off
}
