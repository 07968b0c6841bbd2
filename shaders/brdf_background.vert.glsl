//VTK::System::Dec
// A square over the whole picture at the far plane; `ray` is the direction seen, in coordinates of the environment map.
in vec4 ndCoordIn;   // the attributes of vtkOpenGLQuadHelper
in vec2 texCoordIn;  // 0 to 1
uniform mat4 brdfClipToEnvironment;
out vec3 ray;
void main()
{
  gl_Position = vec4(ndCoordIn.xy, 1.0, 1.0);
  vec4 place = brdfClipToEnvironment * vec4(2.0 * texCoordIn - 1.0, 1.0, 1.0);
  ray = place.xyz / place.w;
}
