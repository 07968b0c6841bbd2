//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : enable
//VTK::Output::Dec
//BRDF::Light::Dec
// Light reflected by a surface whose visible points are known: see vtkBRDFDeferredShading.
uniform sampler2D brdfSurfaceNormal;   // unit, in view coordinates; A: distance along the view, or depth in
                                       // a parallel projection; 0 where nothing is seen
uniform sampler2D brdfSurfaceTangent;  // the same where any will do
uniform mat4 brdfViewToClip;
uniform int brdfParallel;              // 1: parallel projection
in vec3 nearPoint;
in vec3 farPoint;
void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 normal = texelFetch(brdfSurfaceNormal, pixel, 0);
  if (normal.w <= 0.0)
  {
    discard;
  }
  float share = brdfParallel != 0 ? normal.w : (normal.w + nearPoint.z) / (nearPoint.z - farPoint.z);
  vec3 position = mix(nearPoint, farPoint, share);
  vec4 clip = brdfViewToClip * vec4(position, 1.0);
  vec3 tangent = texelFetch(brdfSurfaceTangent, pixel, 0).xyz;
  vec3 viewer = brdfParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-position);
  gl_FragDepth = 0.5 * clip.z / clip.w + 0.5;
  gl_FragData[0] = vec4(brdfReflected(position, viewer, normal.xyz, tangent), 1.0);
}
