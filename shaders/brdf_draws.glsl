// Environment light on terms that may be turned about the normal, by draws made in advance: brdf::ViewerDraws.
uniform usamplerBuffer brdfDraws;

// What a viewer fixes: the same set of draws of both tabulated viewers beside it, and how to place them.
struct brdfDrawer
{
  int first;    // texel of the lower one's set
  int next;     // texels from there to the upper one's
  uint number;  // of the sequence that chooses between the two, and
  uint upper;   // what it stays below where it chooses the upper one
  mat3 axes;    // of the plane of incidence, in coordinates of the map; the viewer lies in x-z
  vec3 viewer;  // in coordinates of the map
  vec2 wo;      // sine and cosine of its polar angle
  vec4 turns;   // cosine and sine of the angles from the lower and from the upper tabulated viewer
};

// `sets` sets of `stride` draws of each tabulated viewer from texel `first` on. Where the plane of incidence is one of
// symmetry, half of the pixels take the draws mirrored.
brdfDrawer brdfDrawerOf(vec3 wo, mat3 frame, uvec2 numbers, int first, int stride, int sets, bool symmetric)
{
  brdfDrawer d;
  d.wo = vec2(length(wo.xy), wo.z);
  vec2 azimuth = d.wo.x > 0.0 ? wo.xy / d.wo.x : vec2(1.0, 0.0);
  float side = symmetric && (numbers.y & 1u) != 0u ? -1.0 : 1.0;
  d.axes = mat3(frame * vec3(azimuth, 0.0), frame * (side * vec3(-azimuth.y, azimuth.x, 0.0)), frame[2]);
  d.viewer = frame * wo;
  const float last = BRDF_VIEWERS - 1.0;
  float above = brdf_atan2(wo.z, d.wo.x);
  float place = clamp((1.0 - sqrt(above * 0.636619772)) * last, 0.0, last);
  float lower = min(floor(place), last - 1.0);
  vec2 left = 1.0 - vec2(lower, lower + 1.0) / last, turns = max(1.57079633 * left * left, 0.00104719755) - above;
  d.turns = vec4(cos(turns), sin(turns)).xzyw;
  d.next = stride * sets;
  d.first = first + int(lower) * d.next + stride * int(brdfUnit(numbers).x * float(sets));
  d.number = numbers.y;
  d.upper = uint((place - lower) * 4294967040.0);
  return d;
}

bool brdfIsUpper(brdfDrawer d, int i)
{
  return d.number + uint(i) * 3242174889u < d.upper;
}

// Draw i.
uvec4 brdfDrawAt(brdfDrawer d, int i)
{
  return texelFetch(brdfDraws, d.first + i + (brdfIsUpper(d, i) ? d.next : 0));
}

// The direction of its light in coordinates of the map, times q (ViewerDraws::words); not `above` the horizon it does not
// count.
vec3 brdfDrawnLight(brdfDrawer d, int i, uvec4 draw, out bool above)
{
  vec2 slopes = uintBitsToFloat(draw.xy);
  vec2 turn = int(draw.w) >= 0 ? vec2(1.0, 0.0) : brdfIsUpper(d, i) ? d.turns.zw : d.turns.xy;
  vec3 h = vec3(slopes.x * turn.x + turn.y, slopes.y, turn.x - slopes.x * turn.y);
  float q = 0.5 * dot(slopes, slopes) + 0.5, along = h.x * d.wo.x + h.z * d.wo.y;
  above = along * h.z > q * d.wo.y;
  return along * (d.axes * h) - q * d.viewer;
}

// Three weights: see ViewerDraws::words. Each is worth 2^23 times more here.
vec3 brdfDrawnWeights(uint word)
{
  ivec3 parts = ivec3(int(word << 23u), int(word << 14u), int(word << 5u)) & int(0xff800000u);
  return intBitsToFloat(int((word >> 27u) + 96u) << 23) * vec3(parts);
}
