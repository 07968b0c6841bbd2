// Draws and density of brdf::TabulatedSampler, whose tables brdfSamplers holds (TabulatedSampler::texels): polar charts
// of the light for a set of viewers, between which they are mixed. x = sin^2(theta / 2); see
// libbrdf/sampling/SamplingChart.h for the charts.
uniform samplerBuffer brdfSamplers;

struct brdfSampler
{
  int first;   // texel of the first viewer
  int thetas;  // polar angles of viewers
  int phis;    // azimuths
  int search;  // largest step of a search, at most 128
};

// What a viewer fixes. Of the four neighbours two have a weight where the surface may be turned.
struct brdfViewer
{
  vec3 wo;
  vec2 azimuth;  // cosine and sine
  vec2 zero;     // of the azimuth at which phi starts in the charts about the normal
  float sine;    // of the polar angle
  vec4 weights;  // of the neighbours
  vec3 shares[4];   // of each: the cosine and its charts
  ivec3 tables[8];  // rows, columns and first texel of the neighbours' two charts
};

void brdfNeighbour(brdfSampler s, inout brdfViewer v, int k, int node)
{
  int at = s.first + 3 * node;
  v.shares[k] = texelFetch(brdfSamplers, at).xyz;
  ivec3 shift = ivec3(0, 0, s.first);
  v.tables[2 * k] = ivec3(texelFetch(brdfSamplers, at + 1).xyz) + shift;
  v.tables[2 * k + 1] = ivec3(texelFetch(brdfSamplers, at + 2).xyz) + shift;
}

brdfViewer brdfViewerOf(brdfSampler s, vec3 wo, bool turning)
{
  brdfViewer v;
  v.wo = wo;
  v.sine = length(wo.xy);
  v.azimuth = v.sine > 0.0 ? wo.xy / v.sine : vec2(1.0, 0.0);
  v.zero = turning ? v.azimuth : vec2(1.0, 0.0);
  // Angle above the horizon over 90 degrees: as exact at grazing as elsewhere.
  float steps = (1.0 - sqrt(brdf_atan2(wo.z, v.sine) * 0.636619772)) * float(s.thetas - 1);
  steps = clamp(steps, 0.0, float(s.thetas - 1));
  int t = min(int(steps), s.thetas - 2);
  float upper = steps - float(t);
  v.weights = vec4(1.0 - upper, upper, 0.0, 0.0);
  if (turning)
  {
    brdfNeighbour(s, v, 0, t);
    brdfNeighbour(s, v, 1, t + 1);
    return v;
  }
  float turn = brdf_atan2(v.azimuth.y, v.azimuth.x) * 0.159154943 * float(s.phis);
  turn += turn < 0.0 ? float(s.phis) : 0.0;
  int p = min(int(turn), s.phis - 1);
  float after = turn - float(p);
  v.weights = vec4((1.0 - after) * v.weights.xy, after * v.weights.xy);
  int near = p * s.thetas + t, next = (p + 1 < s.phis ? p + 1 : 0) * s.thetas + t;
  brdfNeighbour(s, v, 0, near);
  brdfNeighbour(s, v, 1, near + 1);
  brdfNeighbour(s, v, 2, next);
  brdfNeighbour(s, v, 3, next + 1);
  return v;
}

int brdfStep(int first, int count, int part, float number, int cell, int step)
{
  int next = cell + step;
  vec4 start = texelFetch(brdfSamplers, first + min(next, count - 1));
  return next < count && (part == 0 ? start.x : start.y) <= number ? next : cell;
}

// Of `count` cells from texel `first` on, the one whose end (part 0) or share (part 1) is the last not above `number`. The
// largest step is a constant where this is called, so that only the steps needed are left; a loop would count towards the
// 65,536 turns that some software devices grant a fragment.
int brdfCell(int first, int count, int search, int part, float number)
{
  int cell = 0;
  if (search >= 128) cell = brdfStep(first, count, part, number, cell, 128);
  if (search >= 64) cell = brdfStep(first, count, part, number, cell, 64);
  if (search >= 32) cell = brdfStep(first, count, part, number, cell, 32);
  if (search >= 16) cell = brdfStep(first, count, part, number, cell, 16);
  if (search >= 8) cell = brdfStep(first, count, part, number, cell, 8);
  if (search >= 4) cell = brdfStep(first, count, part, number, cell, 4);
  if (search >= 2) cell = brdfStep(first, count, part, number, cell, 2);
  return brdfStep(first, count, part, number, cell, 1);
}

// A point (x, phi) of a table and its density per solid angle of the chart: the point that two numbers draw, or, where
// `drawn` is false, one that is given. One search serves both.
vec3 brdfTablePoint(ivec3 table, int search, bool drawn, vec2 number)
{
  int part = drawn ? 1 : 0;
  int row = brdfCell(table.z, table.x, search, part, number.x);
  vec4 across = texelFetch(brdfSamplers, table.z + row);
  int start = table.z + table.x + row * table.y;
  vec4 along = texelFetch(brdfSamplers, start + brdfCell(start, table.y, search, part, number.y));
  vec2 sizes = vec2(across.z - across.x, along.z - along.x), shares = vec2(across.w - across.y, along.w - along.y);
  vec2 place = clamp((number - vec2(across.y, along.y)) / shares, 0.0, 1.0);
  vec2 point = drawn ? vec2(across.x, along.x) + place * sizes : number;
  float density = shares.x * shares.y / (2.0 * sizes.x * sizes.y);
  return vec3(point, table.x > 0 && point.x <= across.z ? density : 0.0);
}

// A point (x, phi) of a table from two numbers.
vec2 brdfTableDraw(ivec3 table, int search, vec2 u)
{
  vec2 point;
  int row = brdfCell(table.z, table.x, search, 1, u.x);
  vec4 cell = texelFetch(brdfSamplers, table.z + row);
  point.x = mix(cell.x, cell.z, clamp((u.x - cell.y) / (cell.w - cell.y), 0.0, 1.0));
  int start = table.z + table.x + row * table.y;
  cell = texelFetch(brdfSamplers, start + brdfCell(start, table.y, search, 1, u.y));
  point.y = mix(cell.x, cell.z, clamp((u.y - cell.y) / (cell.w - cell.y), 0.0, 1.0));
  return point;
}

// Its density per solid angle of the chart, d omega = 2 dx dphi.
float brdfTableDensity(ivec3 table, int search, vec2 point)
{
  int row = brdfCell(table.z, table.x, search, 0, point.x);
  vec4 across = texelFetch(brdfSamplers, table.z + row);
  int start = table.z + table.x + row * table.y;
  vec4 along = texelFetch(brdfSamplers, start + brdfCell(start, table.y, search, 0, point.y));
  float density = (across.w - across.y) * (along.w - along.y) / (2.0 * (across.z - across.x) * (along.z - along.x));
  return table.x > 0 && point.x <= across.z ? density : 0.0;
}

float brdfPositiveAngle(float y, float x)
{
  float angle = brdf_atan2(y, x);
  return angle < 0.0 ? min(angle + 6.28318531, 6.28318501) : angle;
}

// Charts: (x, phi, d omega_i / (2 dx dphi)) of a light, and the light at a point.
vec3 brdfToHalf(brdfViewer v, vec3 wi)
{
  vec3 h = wi + v.wo;
  float squared = dot(h.xy, h.xy), size = sqrt(squared + h.z * h.z);
  return vec3(squared / (2.0 * size * (size + h.z)),
    brdfPositiveAngle(v.zero.x * h.y - v.zero.y * h.x, dot(v.zero, h.xy)), 2.0 * size);
}

vec3 brdfToLight(brdfViewer v, vec3 wi)
{
  return vec3(dot(wi.xy, wi.xy) / (2.0 * (1.0 + wi.z)),
    brdfPositiveAngle(v.zero.x * wi.y - v.zero.y * wi.x, dot(v.zero, wi.xy)), 1.0);
}

vec3 brdfToRetro(brdfViewer v, vec3 wi)
{
  vec3 d = wi - v.wo;
  float along = v.wo.z * dot(v.azimuth, d.xy) - v.sine * d.z;
  float across = v.azimuth.x * d.y - v.azimuth.y * d.x;
  return vec3(min(1.0, 0.25 * dot(d, d)), brdfPositiveAngle(across, along), 1.0);
}

vec3 brdfPolar(vec2 point)
{
  float sine = 2.0 * sqrt(point.x * (1.0 - point.x));
  return vec3(sine * cos(point.y), sine * sin(point.y), 1.0 - 2.0 * point.x);
}

vec3 brdfFromLight(brdfViewer v, vec2 point)
{
  vec3 p = brdfPolar(point);
  return vec3(v.zero.x * p.x - v.zero.y * p.y, v.zero.y * p.x + v.zero.x * p.y, p.z);
}

vec3 brdfFromHalf(brdfViewer v, vec2 point)
{
  vec3 h = brdfFromLight(v, point);
  float facing = dot(h, v.wo);
  return facing > 0.0 ? 2.0 * facing * h - v.wo : vec3(0.0);
}

vec3 brdfFromRetro(brdfViewer v, vec2 point)
{
  vec3 p = brdfPolar(point);
  float along = v.wo.z * p.x + v.sine * p.z;
  return vec3(v.azimuth.x * along - v.azimuth.y * p.y, v.azimuth.y * along + v.azimuth.x * p.y,
    v.wo.z * p.z - v.sine * p.x);
}

// Takes one of four choices by their shares and stretches the number for use again.
int brdfPick(vec4 shares, inout float u)
{
  vec4 ends = vec4(shares.x, shares.x + shares.y, shares.x + shares.y + shares.z, 0.0);
  int k = u < ends.x ? 0 : u < ends.y ? 1 : u < ends.z ? 2 : 3;
  // Rounding can leave the number above the sum.
  k = k == 3 && !(shares.w > 0.0) ? 2 : k;
  k = k == 2 && !(shares.z > 0.0) ? 1 : k;
  k = k == 1 && !(shares.y > 0.0) ? 0 : k;
  float below = k == 0 ? 0.0 : k == 1 ? ends.x : k == 2 ? ends.y : ends.z;
  float share = k == 0 ? shares.x : k == 1 ? shares.y : k == 2 ? shares.z : shares.w;
  u = clamp((u - below) / max(share, 1e-30), 0.0, 0.99999994);
  return k;
}

vec3 brdfSharesOf(brdfViewer v, bool turning, int k)
{
  vec3 shares = k == 0 ? v.shares[0] : v.shares[1];
  if (!turning)
    shares = k < 2 ? shares : k == 2 ? v.shares[2] : v.shares[3];
  return shares;
}

ivec3 brdfTableOf(brdfViewer v, bool turning, int k, int chart)
{
  ivec3 first = k == 0 ? v.tables[0] : v.tables[2], second = k == 0 ? v.tables[1] : v.tables[3];
  if (!turning)
  {
    first = k < 2 ? first : k == 2 ? v.tables[4] : v.tables[6];
    second = k < 2 ? second : k == 2 ? v.tables[5] : v.tables[7];
  }
  return chart == 0 ? first : second;
}

// The part that a number chooses (0 the cosine, then the charts) of the neighbour that it chooses, and that one's table.
int brdfPart(brdfViewer v, bool turning, inout float u, out ivec3 table)
{
  int k = brdfPick(v.weights, u);
  int part = brdfPick(vec4(brdfSharesOf(v, turning, k), 0.0), u);
  table = brdfTableOf(v, turning, k, part == 2 ? 1 : 0);
  return part;
}

vec3 brdfCosineDraw(vec2 u)
{
  float r = sqrt(u.x), angle = 6.28318531 * u.y;
  return vec3(r * cos(angle), r * sin(angle), sqrt(1.0 - u.x));
}

// The neighbours' density of one chart, at its point.
float brdfChartDensity(brdfSampler s, brdfViewer v, bool turning, int chart, vec3 point)
{
  float sum = v.weights.x * v.shares[0][chart + 1] * brdfTableDensity(v.tables[chart], s.search, point.xy) +
              v.weights.y * v.shares[1][chart + 1] * brdfTableDensity(v.tables[2 + chart], s.search, point.xy);
  if (!turning)
  {
    sum += v.weights.z * v.shares[2][chart + 1] * brdfTableDensity(v.tables[4 + chart], s.search, point.xy) +
           v.weights.w * v.shares[3][chart + 1] * brdfTableDensity(v.tables[6 + chart], s.search, point.xy);
  }
  return point.z > 0.0 ? sum / point.z : 0.0;
}

float brdfCosineDensity(brdfViewer v, bool turning, vec3 wi)
{
  float share = v.weights.x * v.shares[0].x + v.weights.y * v.shares[1].x;
  share += turning ? 0.0 : v.weights.z * v.shares[2].x + v.weights.w * v.shares[3].x;
  return share * wi.z * 0.318309886;
}
