// A height field (brdf::HeightField) that rays search by cells and by squares of 2, 4, 8, ... cells whose least and most
// heights are known (the maximum mipmaps of Tevs, Ihrke, Seidel 2008, DOI 10.1145/1342250.1342279), exactly: a ray is
// above the two triangles of every cell until it crosses one, and then below. Over a triangle its height above it is
// linear, so that a crossing is a change of sign between the ends, and nothing falls through. A position is a cell
// (BrdfPath::place), the place in it in [0, 1], and z.
uniform sampler2D brdfHeights;  // brdf::FieldTexels: heights at the corners (0, 0), (1, 0), (1, 1), (0, 1) of cells; least
                                // and most height of squares of 2, 4, ... cells
uniform int brdfLevelRows[28];  // first row of each level
uniform int brdfTop;           // level whose only square is the tile
uniform ivec2 brdfSize;        // cells
uniform vec3 brdfLattice;      // (cells a unit of length along x and y; 0 along which nothing changes), 1
uniform vec2 brdfEnds;         // z below and above everything

void brdfPutAbove(inout BrdfPath path, uvec4 random)
{
  uvec2 x = brdfProduct(random.x, uint(brdfSize.x)), y = brdfProduct(random.y, uint(brdfSize.y));
  path.place = x.x | y.x << 16;
  path.position = vec3(brdfUnit(x.y), brdfUnit(y.y), brdfEnds.y);
}

// Distances to the borders that are ahead, BRDF_NEVER to those that the ray is parallel to.
vec3 brdfToBorders(vec3 way, vec3 inverse)
{
  return mix(max(way * inverse, 0.0), vec3(BRDF_NEVER), vec3(equal(inverse, vec3(0.0))));
}

int brdfFollow(inout BrdfPath path, inout int steps, out float distance, out int facet, out vec3 normal, out bool front)
{
  vec3 d = path.direction * brdfLattice, p = path.position;
  bvec3 moves = greaterThan(abs(d), vec3(1e-25));
  vec3 inverse = mix(vec3(0.0), 1.0 / mix(vec3(1.0), d, vec3(moves)), vec3(moves)), forward = vec3(greaterThan(d, vec3(0.0)));
  ivec2 cell = ivec2(int(path.place & 65535u), int(path.place >> 16));
  front = !brdfWithin(path.media, brdfBelow);
  float side = front ? 1.0 : -1.0;
  bool onLower = (path.state & BRDF_ON_LOWER) != 0u, onUpper = (path.state & BRDF_ON_UPPER) != 0u;
  bool on = onLower || onUpper;
  int level = on ? 0 : min(brdfTop, 4), end = BRDF_ON;
  distance = 0.0;
  facet = 0;
  normal = vec3(0.0, 0.0, 1.0);
  path.searches += path.steps == 0u ? 1u : 0u;
  while (end == BRDF_ON && steps > 0)
  {
    --steps;
    ivec2 corner = cell >> level << level;
    ivec2 size = min(corner + (1 << level), brdfSize) - corner;
    vec2 q = p.xy + vec2(cell - corner);
    vec3 to = brdfToBorders(mix(vec3(0.0, 0.0, brdfEnds.x), vec3(size, brdfEnds.y), forward) - vec3(q, p.z), inverse);
    float toX = to.x, toY = to.y, toZ = to.z;
    float s = min(min(toX, toY), toZ), z = p.z + s * d.z;
    vec4 h = texelFetch(brdfHeights, (cell >> level) + ivec2(0, brdfLevelRows[level]), 0);
    vec2 bounds = level > 0 ? h.xy : vec2(min(min(h.x, h.y), min(h.z, h.w)), max(max(h.x, h.y), max(h.z, h.w)));
    bool clear = front ? min(p.z, z) > bounds.y : max(p.z, z) < bounds.x;
    if (!clear && level > 0)
    {
      --level;
      continue;
    }
    float met = -1.0;
    vec2 slope = vec2(0.0);
    bool upper = false;
    if (!clear)
    {
      // Heights over the lower triangle (x >= y) are h.x + lower.x x + lower.y y, over the upper one likewise.
      vec2 slopeLower = vec2(h.y - h.x, h.z - h.y), slopeUpper = vec2(h.z - h.w, h.w - h.x);
      float lean = p.x - p.y, turn = d.x - d.y;
      upper = on ? onUpper : lean < 0.0 || (lean == 0.0 && turn < 0.0);
      bool crosses = upper ? turn > 0.0 : turn < 0.0;
      float middle = crosses ? min(max(-lean / turn, 0.0), s) : s;
      slope = upper ? slopeUpper : slopeLower;
      float start = side * (p.z - h.x - dot(slope, p.xy)), rise = side * (d.z - dot(slope, d.xy));
      // What starts on a triangle leaves it.
      start = on ? 0.0 : max(start, 0.0);
      float over = on ? max(rise * middle, 0.0) : side * (p.z + middle * d.z - h.x - dot(slope, p.xy + middle * d.xy));
      if (over < 0.0)
      {
        met = middle * (start / (start - over));
      }
      else if (crosses && middle < s)
      {
        upper = !upper;
        slope = upper ? slopeUpper : slopeLower;
        float last = side * (z - h.x - dot(slope, p.xy + s * d.xy));
        met = last < 0.0 ? mix(middle, s, over / (over - last)) : -1.0;
      }
    }
    on = false;
    if (met >= 0.0)
    {
      p.xy = clamp(p.xy + met * d.xy, 0.0, 1.0);
      p.z = h.x + dot(slope, p.xy);
      distance += met;
      normal = normalize(vec3(-slope * brdfLattice.xy, 1.0));
      path.state = (path.state & ~(BRDF_ON_LOWER | BRDF_ON_UPPER)) | (upper ? BRDF_ON_UPPER : BRDF_ON_LOWER);
      end = BRDF_FACET;
    }
    else if (s >= BRDF_NEVER)
    {
      steps = 0;
      path.steps += 1048576u;  // for ever between the heights
    }
    else
    {
      distance += s;
      p.z = z;
      path.state &= ~(BRDF_ON_LOWER | BRDF_ON_UPPER);
      if (toZ <= min(toX, toY))
      {
        end = d.z > 0.0 ? BRDF_ABOVE : BRDF_BELOW;
      }
      else
      {
        // Into the next square: exactly from its border.
        bool alongX = toX <= toY;
        q = clamp(q + s * d.xy, vec2(0.0), vec2(size));
        ivec2 inside = min(ivec2(q), size - 1), parent = cell >> (level + 1);
        p.xy = q - vec2(inside);
        cell = corner + inside;
        bool wraps = false;
        if (alongX)
        {
          cell.x = d.x > 0.0 ? corner.x + size.x : corner.x - 1;
          p.x = d.x > 0.0 ? 0.0 : 1.0;
          wraps = cell.x < 0 || cell.x >= brdfSize.x;
          cell.x = cell.x < 0 ? brdfSize.x - 1 : cell.x >= brdfSize.x ? 0 : cell.x;
        }
        else
        {
          cell.y = d.y > 0.0 ? corner.y + size.y : corner.y - 1;
          p.y = d.y > 0.0 ? 0.0 : 1.0;
          wraps = cell.y < 0 || cell.y >= brdfSize.y;
          cell.y = cell.y < 0 ? brdfSize.y - 1 : cell.y >= brdfSize.y ? 0 : cell.y;
        }
        level = wraps || any(notEqual(cell >> (level + 1), parent)) ? min(level + 1, brdfTop) : level;
      }
    }
  }
  path.place = uint(cell.x) | uint(cell.y) << 16;
  path.position = p;
  return end;
}
