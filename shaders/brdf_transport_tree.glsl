// Triangles, or spheres over a plane (brdf::TiledMesh, brdf::SpherePacking), that rays search by a tree of boxes over
// those that reach into one tile (brdf::TileTree); a ray that leaves the tile on one side comes back on the other.
// Coordinates count from the middle of the tile. What a ray was within before tells on which side of a facet it is where
// rounding cannot: a ray meets the front of what it is outside of, a little behind its start too, and not at once the
// back.
uniform samplerBuffer brdfNodes;       // of each: least and most corner of both children, with link and count in w
uniform samplerBuffer brdfPrimitives;  // of a sphere: centre, radius; of a triangle: corners, with facet and medium in w
uniform vec2 brdfHalf;                 // of the tile
uniform vec2 brdfEnds;                 // z below and above everything
uniform float brdfRounding;            // how far from a facet rounding may put a point
uniform float brdfPlane;               // z of the plane
uniform int brdfPlaneMedium;           // -1: opaque; -2: no plane
uniform int brdfSphereMedium;          // -1: opaque

const uint BRDF_NOTHING = 0u, BRDF_PLANE = 4294967295u;  // BrdfPath::place: where it starts; else primitive + 1

void brdfPutAbove(inout BrdfPath path, uvec4 random)
{
  path.place = BRDF_NOTHING;
  path.position = vec3((2.0 * vec2(brdfUnit(random.x), brdfUnit(random.y)) - 1.0) * brdfHalf, brdfEnds.y);
}

struct BrdfSearch
{
  vec3 origin, direction, inverse;
  vec3 shear;       // of a triangle's test
  int axis;         // along which the ray is longest
  uint from;        // primitive + 1 where it starts
  uvec2 media;
  float nearest;    // distance
  int primitive;    // -1: none
  bool front;
  vec3 shares;      // of a triangle's corners
};

vec3 brdfTurned(vec3 v, int axis)
{
  return axis == 0 ? v.yzx : axis == 1 ? v.zxy : v;
}

// Whether a meeting at a distance counts, where cosine is that of the direction against the normal.
bool brdfMeets(BrdfSearch search, float at, float cosine, bool front, int medium)
{
  float beside = at * cosine;
  return at < search.nearest &&
         (front != brdfWithin(search.media, medium) ? beside > -2.0 * brdfRounding : beside > 2.0 * brdfRounding);
}

#ifdef BRDF_SPHERES
// E. Haines, J. Gunther, T. Akenine-Moller 2019, Ray Tracing Gems, ch. 7, DOI 10.1007/978-1-4842-4427-2_7.
void brdfTry(inout BrdfSearch search, int primitive)
{
  vec4 sphere = texelFetch(brdfPrimitives, primitive);
  vec3 f = search.origin - sphere.xyz;
  float b = dot(f, search.direction);
  if (uint(primitive + 1) == search.from)
  {
    // On the sphere: along its chord, or away.
    if (b < 0.0 && -2.0 * b < search.nearest)
    {
      search.nearest = -2.0 * b;
      search.primitive = primitive;
      search.front = false;
    }
    return;
  }
  vec3 l = f - b * search.direction;
  float squared = sphere.w * sphere.w, discriminant = squared - dot(l, l);
  if (!(discriminant > 0.0))
    return;
  float root = sqrt(discriminant), cosine = root / sphere.w, q = -b + (b > 0.0 ? -root : root);
  float length2 = dot(f, f), outside = (sqrt(length2) - sphere.w) * (sqrt(length2) + sphere.w);
  float other = outside / q, near = min(other, q), far = max(other, q);
  if (brdfMeets(search, near, cosine, true, brdfSphereMedium))
  {
    search.nearest = max(near, 0.0);
    search.primitive = primitive;
    search.front = true;
  }
  else if (brdfMeets(search, far, cosine, false, brdfSphereMedium))
  {
    search.nearest = max(far, 0.0);
    search.primitive = primitive;
    search.front = false;
  }
}
#else
// S. Woop, C. Benthin, I. Wald 2013, "Watertight Ray/Triangle Intersection", JCGT 2(1), 65-82: neighbours agree on which
// side of their edge a ray passes.
void brdfTry(inout BrdfSearch search, int primitive)
{
  if (uint(primitive + 1) == search.from)
    return;
  vec4 first = texelFetch(brdfPrimitives, 3 * primitive), second = texelFetch(brdfPrimitives, 3 * primitive + 1);
  vec4 third = texelFetch(brdfPrimitives, 3 * primitive + 2);
  vec3 a = brdfTurned(first.xyz - search.origin, search.axis), b = brdfTurned(second.xyz - search.origin, search.axis);
  vec3 c = brdfTurned(third.xyz - search.origin, search.axis);
  a.xy -= search.shear.xy * a.z;
  b.xy -= search.shear.xy * b.z;
  c.xy -= search.shear.xy * c.z;
  vec3 edges = vec3(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x);
  if (min(min(edges.x, edges.y), edges.z) < 0.0 && max(max(edges.x, edges.y), edges.z) > 0.0)
    return;
  float sum = edges.x + edges.y + edges.z;
  if (sum == 0.0)
    return;
  vec3 shares = edges / sum;
  float at = search.shear.z * dot(shares, vec3(a.z, b.z, c.z));
  float along = dot(search.direction, normalize(cross(second.xyz - first.xyz, third.xyz - first.xyz)));
  if (brdfMeets(search, at, abs(along), along < 0.0, int(second.w)))
  {
    search.nearest = max(at, 0.0);
    search.primitive = primitive;
    search.front = along < 0.0;
    search.shares = shares;
  }
}
#endif

// Distance at which a box is entered, BRDF_NEVER where it is passed by or is beyond the nearest meeting. Widened by what
// rounding may take (T. Ize 2013, "Robust BVH Ray Traversal", JCGT 2(2), 12-27).
float brdfBox(BrdfSearch search, vec3 least, vec3 most)
{
  vec3 one = (least - search.origin) * search.inverse, two = (most - search.origin) * search.inverse;
  vec3 enter = min(one, two), leave = max(one, two);
  float near = max(max(enter.x, enter.y), max(enter.z, -16.0 * brdfRounding));
  float far = min(min(leave.x, leave.y), min(leave.z, search.nearest));
  return near <= far + 4e-7 * abs(far) ? near : BRDF_NEVER;
}

// False where the steps do not last; then nothing was found.
bool brdfFind(inout BrdfSearch search, inout int steps)
{
  int stack[48];
  int waiting = 0, node = 0;
  while (node >= 0 && steps > 0)
  {
    --steps;
    vec4 least0 = texelFetch(brdfNodes, 4 * node), most0 = texelFetch(brdfNodes, 4 * node + 1);
    vec4 least1 = texelFetch(brdfNodes, 4 * node + 2), most1 = texelFetch(brdfNodes, 4 * node + 3);
    float enter0 = brdfBox(search, least0.xyz, most0.xyz), enter1 = brdfBox(search, least1.xyz, most1.xyz);
    // Leaves, the nearer first; the nearer of inner nodes next.
    bool swaps = enter1 < enter0;
    ivec2 near = swaps ? ivec2(int(least1.w), int(most1.w)) : ivec2(int(least0.w), int(most0.w));
    ivec2 far = swaps ? ivec2(int(least0.w), int(most0.w)) : ivec2(int(least1.w), int(most1.w));
    float enterNear = min(enter0, enter1), enterFar = max(enter0, enter1);
    int next = -1;
    if (enterNear < BRDF_NEVER)
    {
      for (int k = 0; k < near.y; ++k)
      {
        --steps;
        brdfTry(search, near.x + k);
      }
      next = near.y == 0 ? near.x : -1;
    }
    if (enterFar < BRDF_NEVER && enterFar <= search.nearest)
    {
      for (int k = 0; k < far.y; ++k)
      {
        --steps;
        brdfTry(search, far.x + k);
      }
      if (far.y == 0)
      {
        if (next >= 0)
        {
          stack[waiting] = far.x;
          ++waiting;
        }
        else
        {
          next = far.x;
        }
      }
    }
    if (next < 0 && waiting > 0)
    {
      --waiting;
      next = stack[waiting];
    }
    node = next;
  }
  return node < 0;
}

float brdfToEnd(float origin, float direction, float half1)
{
  float way = direction > 0.0 ? half1 - origin : -half1 - origin;
  return abs(direction) > 1e-25 ? max(way / direction, 0.0) : BRDF_NEVER;
}

// The meeting that the search found: point, normal and facet.
void brdfResolve(BrdfSearch search, out vec3 point, out vec3 normal, out int facet)
{
#ifdef BRDF_SPHERES
  vec4 sphere = texelFetch(brdfPrimitives, search.primitive);
  normal = normalize(search.origin - sphere.xyz + search.nearest * search.direction);
  point = sphere.xyz + sphere.w * normal;
  facet = 0;
#else
  vec4 first = texelFetch(brdfPrimitives, 3 * search.primitive), second = texelFetch(brdfPrimitives, 3 * search.primitive + 1);
  vec4 third = texelFetch(brdfPrimitives, 3 * search.primitive + 2);
  normal = normalize(cross(second.xyz - first.xyz, third.xyz - first.xyz));
  point = search.shares.x * first.xyz + search.shares.y * second.xyz + search.shares.z * third.xyz;
  facet = int(first.w);
#endif
}

int brdfFollow(inout BrdfPath path, inout int steps, out float distance, out int facet, out vec3 normal, out bool front)
{
  BrdfSearch search;
  search.direction = path.direction;
  vec3 d = search.direction, size = abs(d);
  search.inverse = 1.0 / mix(d, vec3(1e-20), vec3(lessThan(size, vec3(1e-20))));
  search.axis = size.z >= max(size.x, size.y) ? 2 : size.x >= size.y ? 0 : 1;
  vec3 turned = brdfTurned(d, search.axis);
  search.shear = vec3(turned.xy, 1.0) / turned.z;
  search.media = path.media;
  int end = BRDF_ON;
  bool lasts = true;
  distance = 0.0;
  facet = 0;
  normal = vec3(0.0, 0.0, 1.0);
  front = true;
  while (end == BRDF_ON && lasts && steps > 0)
  {
    --steps;
    vec3 p = path.position;
    float toX = brdfToEnd(p.x, d.x, brdfHalf.x), toY = brdfToEnd(p.y, d.y, brdfHalf.y), border = min(toX, toY);
    float toZ = abs(d.z) > 1e-25 ? max(((d.z > 0.0 ? brdfEnds.y : brdfEnds.x) - p.z) / d.z, 0.0) : BRDF_NEVER;
    bool under = brdfWithin(path.media, brdfPlaneMedium);
    float toPlane = brdfPlaneMedium > -2 && path.place != BRDF_PLANE && (under ? d.z > 0.0 : d.z < 0.0)
      ? max((brdfPlane - p.z) / d.z, 0.0) : BRDF_NEVER;
    float most = min(min(border + 4.0 * brdfRounding, toZ), toPlane);
    search.origin = p;
    search.from = path.place;
    search.nearest = most;
    search.primitive = -1;
    search.front = true;
    search.shares = vec3(0.0);
    lasts = brdfFind(search, steps);
    if (!lasts)
    {
      // From here again when next there are steps.
    }
    else if (search.primitive >= 0)
    {
      brdfResolve(search, p, normal, facet);
      distance += search.nearest;
      front = search.front;
      path.searches += 1u;
      path.place = uint(search.primitive + 1);
      end = BRDF_FACET;
      path.position = p;
    }
    else
    {
      path.searches += 1u;
      bool atPlane = toPlane <= min(border, toZ), leaves = !atPlane && toZ <= border;
      float way = atPlane ? toPlane : leaves ? toZ : border;
      distance += way;
      p += way * d;
      path.place = BRDF_NOTHING;
      if (atPlane)
      {
        p.z = brdfPlane;
        path.place = BRDF_PLANE;
        facet = 1;
        normal = vec3(0.0, 0.0, 1.0);
        front = !under;
        end = BRDF_FACET;
      }
      else if (leaves)
      {
        end = d.z > 0.0 ? BRDF_ABOVE : BRDF_BELOW;
      }
      else if (border >= BRDF_NEVER)
      {
        lasts = false;
        path.steps += 1048576u;  // for ever between the ends
      }
      else
      {
        // Into the next tile: exactly from its border.
        p.x = toX <= toY ? (d.x > 0.0 ? -brdfHalf.x : brdfHalf.x) : clamp(p.x, -brdfHalf.x, brdfHalf.x);
        p.y = toX <= toY ? clamp(p.y, -brdfHalf.y, brdfHalf.y) : (d.y > 0.0 ? -brdfHalf.y : brdfHalf.y);
      }
      path.position = p;
    }
  }
  // A little beyond the border of the tile.
  vec2 beyond = vec2(greaterThan(path.position.xy, brdfHalf)) - vec2(lessThan(path.position.xy, -brdfHalf));
  path.position.xy -= 2.0 * brdfHalf * beyond;
  path.place = beyond == vec2(0.0) || path.place == BRDF_PLANE ? path.place : BRDF_NOTHING;
  steps = lasts ? steps : 0;
  return end;
}
