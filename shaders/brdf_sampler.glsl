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
  int warps;   // texel of the first viewer's shares in TabulatedSampler::Warps
};

// What a viewer fixes. Of the four neighbours two have a weight where the surface may be turned.
struct brdfViewer
{
  vec3 wo;
  vec2 azimuth;  // cosine and sine
  vec2 zero;     // of the azimuth at which phi starts in the charts about the normal
  float sine;    // of the polar angle
  vec4 weights;  // of the neighbours
  ivec4 nodes;   // numbers of the neighbours
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

// Without what their tables hold.
brdfViewer brdfViewerAlone(brdfSampler s, vec3 wo, bool turning)
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
  v.nodes = ivec4(t, t + 1, t, t + 1);
  if (turning)
    return v;
  float turn = brdf_atan2(v.azimuth.y, v.azimuth.x) * 0.159154943 * float(s.phis);
  turn += turn < 0.0 ? float(s.phis) : 0.0;
  int p = min(int(turn), s.phis - 1);
  float after = turn - float(p);
  v.weights = vec4((1.0 - after) * v.weights.xy, after * v.weights.xy);
  v.nodes += s.thetas * ivec2(p, p + 1 < s.phis ? p + 1 : 0).xxyy;
  return v;
}

brdfViewer brdfViewerOf(brdfSampler s, vec3 wo, bool turning)
{
  brdfViewer v = brdfViewerAlone(s, wo, turning);
  brdfNeighbour(s, v, 0, v.nodes.x);
  brdfNeighbour(s, v, 1, v.nodes.y);
  if (!turning)
  {
    brdfNeighbour(s, v, 2, v.nodes.z);
    brdfNeighbour(s, v, 3, v.nodes.w);
  }
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

// The same viewer for draws by brdf::PolarWarp.
struct brdfWarpViewer
{
  brdfViewer viewer;
  vec4 ends;    // of the neighbours' intervals in [0, 1)
  vec4 scales;  // 1 / their lengths
  vec4 shares;  // of their first charts
};

brdfWarpViewer brdfWarpViewerOf(brdfSampler s, vec3 wo, bool turning, bool charts)
{
  brdfWarpViewer w;
  w.viewer = brdfViewerAlone(s, wo, turning);
  vec4 weights = w.viewer.weights;
  w.ends = vec4(weights.x, weights.x + weights.y, weights.x + weights.y + weights.z, 2.0);
  w.scales = 1.0 / max(weights, vec4(1e-30));
  w.shares = vec4(1.0);
  if (charts)
  {
    ivec4 at = s.warps + w.viewer.nodes;
    w.shares.xy = vec2(texelFetch(brdfSamplers, at.x).x, texelFetch(brdfSamplers, at.y).x);
    if (!turning)
      w.shares.zw = vec2(texelFetch(brdfSamplers, at.z).x, texelFetch(brdfSamplers, at.w).x);
  }
  return w;
}

// The neighbour that a number chooses and its share of the first chart; the number is stretched for use again.
int brdfWarpNeighbour(brdfWarpViewer w, bool turning, inout float u, out float share)
{
  int node = w.viewer.nodes.x;
  float below = 0.0, scale = w.scales.x;
  share = w.shares.x;
  if (u >= w.ends.x)
  {
    node = w.viewer.nodes.y;
    below = w.ends.x;
    scale = w.scales.y;
    share = w.shares.y;
  }
  if (!turning && u >= w.ends.y)
  {
    bool last = u >= w.ends.z;
    node = last ? w.viewer.nodes.w : w.viewer.nodes.z;
    below = last ? w.ends.z : w.ends.y;
    scale = last ? w.scales.w : w.scales.z;
    share = last ? w.shares.w : w.shares.z;
  }
  u = clamp((u - below) * scale, 0.0, 0.99999994);
  return node;
}

// A point (x, phi) of chart `number` of a warp, counted over all viewers, and the chart's solid angle over the density
// of the draw, 2 dx dphi / share.
vec3 brdfWarped(brdfSampler s, int number, vec2 u)
{
  float down = (1.0 - sqrt(1.0 - u.x)) * BRDF_WARP_ROWS, right = u.y * BRDF_WARP_COLUMNS;
  int row = min(int(down), int(BRDF_WARP_ROWS) - 1), column = int(right);
  int rows = int(BRDF_WARP_ROWS) * number + row;
  vec4 cell = texelFetch(brdfSamplers, s.warps + s.thetas * s.phis + rows * int(BRDF_WARP_COLUMNS) + column);
  float left = 2.0 * (BRDF_WARP_ROWS - float(row)), inverse = 1.0 / (left - 1.0), part = down - float(row);
  vec2 place = vec2(min(part * (left - part) * inverse, 1.0), right - float(column));
  return vec3(cell.xz + place * cell.yw,
    2.0 * BRDF_WARP_ROWS * BRDF_WARP_ROWS * BRDF_WARP_COLUMNS * inverse * cell.y * cell.w);
}

// Of what two charts draw, the part that is the half vector's: by the squared sines of theta_h and theta_d.
float brdfHalfPart(vec3 wi, vec3 wo)
{
  vec3 h = wi + wo, d = wi - wo;
  float half1 = dot(h.xy, h.xy) / dot(h, h), difference = 0.25 * dot(d, d);
  return half1 + difference > 0.0 ? difference / (half1 + difference) : 0.5;
}
