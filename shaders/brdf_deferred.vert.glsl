//VTK::System::Dec
// A square over the whole picture, and the line of sight through each of its points, in view coordinates.
in vec4 ndCoordIn;   // the attributes of vtkOpenGLQuadHelper
in vec2 texCoordIn;  // 0 to 1
uniform mat4 brdfClipToView;
out vec3 nearPoint;
out vec3 farPoint;
void main()
{
  gl_Position = vec4(ndCoordIn.xy, 0.0, 1.0);
  vec2 place = 2.0 * texCoordIn - 1.0;
  vec4 point = brdfClipToView * vec4(place, -1.0, 1.0);
  nearPoint = point.xyz / point.w;
  point = brdfClipToView * vec4(place, 1.0, 1.0);
  farPoint = point.xyz / point.w;
}
