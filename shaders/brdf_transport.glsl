// Light through a microsurface (brdf::Transport): one fragment is a ray, or one of its two parts where surfaces split
// light. What a ray is between two draws is kept in textures: a draw takes each at most brdfSteps steps further. Lengths
// are in units of the backend's choice, z outwards; a piece before this one is the geometry's and defines
//   int brdfFollow(inout BrdfPath path, inout int steps, out float distance, out int facet, out vec3 normal,
//                  out bool front)   moves the ray on: to a facet, or out, or as far as the steps last
//   void brdfPutAbove(inout BrdfPath path, uvec4 random)   puts it at a point that is uniform over the tile

const int BRDF_MIRROR = 0, BRDF_CONDUCTOR = 1, BRDF_DIELECTRIC = 2, BRDF_LAMBERTIAN = 3;  // brdf::Facet::Kind

uniform sampler2D brdfPositions, brdfDirections, brdfWeights, brdfAbsorbed;
uniform usampler2D brdfCounts, brdfStates;
uniform usamplerBuffer brdfSources;    // of rays that go on: their texel before, and their number in the draw that began
uniform samplerBuffer brdfFacets;      // of each: (kind, medium or -1), then what its kind has by channel
uniform vec4 brdfMediumIndex[8];       // by channel
uniform vec4 brdfMediumAbsorption[8];  // by channel, 1 / unit of length
uniform bool brdfBegin;                // whether the rays are new
uniform int brdfWidth, brdfJobs;       // of the textures; rays or parts of rays in them
uniform int brdfParts;                 // 2 where light is split, else 1
uniform int brdfSteps;                 // at most
uniform int brdfBounces;
uniform uvec2 brdfSeed, brdfFirst;     // low and high word; of the first ray
uniform vec3 brdfIncident;             // the way that light travels
uniform bool brdfTurning;
uniform vec4 brdfBrought;              // 1 for each channel that is traced

uvec4 brdfRandom(inout BrdfPath path)
{
  uint part = (path.state & BRDF_SPLIT) == 0u ? 0u : (path.state & BRDF_SECOND) == 0u ? 1u : 2u;
  return brdfPhilox(uvec4(path.ray, path.draws++, part), brdfSeed);
}

int brdfSlot(int facet)
{
  return int(texelFetch(brdfFacets, 3 * facet).y);
}

vec4 brdfIndexOf(int medium)
{
  return medium < 0 ? vec4(1.0) : brdfMediumIndex[medium];
}

// brdf::dielectricReflectance: Walter, Marschner, Li, Torrance 2007, eq. 22, DOI 10.2312/EGWR/EGSR07/195-206.
float brdfDielectric(float cosI, float eta, out float cosT)
{
  float N = (eta - 1.0) * (eta + 1.0), g2 = N + cosI * cosI;
  cosT = 0.0;
  if (!(g2 > 0.0))
    return N < 0.0 ? 1.0 : 0.0;
  float g = sqrt(g2), s = g + cosI;
  cosT = min(g / eta, 1.0);
  float difference = N / s, a = difference / s, b = (cosI * s - 1.0) / (cosI * difference + 1.0);
  return min(0.5 * a * a * (1.0 + b * b), 1.0);
}

// brdf::conductorReflectance by channel: Born and Wolf 1999, section 14.2, DOI 10.1017/CBO9781139644181.
vec4 brdfConductor(float cosI, vec4 eta, vec4 k)
{
  float s2 = (1.0 - cosI) * (1.0 + cosI);
  vec4 t = (eta - k) * (eta + k) - s2, ek = eta * k;
  vec4 size = abs(t), other = 2.0 * abs(ek), most = max(max(size, other), 1e-30);
  vec4 big = 0.5 * (most * sqrt((size / most) * (size / most) + (other / most) * (other / most)) + size);
  vec4 small = ek * (ek / max(big, 1e-30));
  bvec4 positive = greaterThan(t, vec4(0.0));
  vec4 a = sqrt(mix(small, big, vec4(positive))), b2 = mix(big, small, vec4(positive));
  vec4 rs = ((a - cosI) * (a - cosI) + b2) / ((a + cosI) * (a + cosI) + b2);
  vec4 above = (a * cosI - s2) * (a * cosI - s2) + b2 * cosI * cosI;
  vec4 below = (a * cosI + s2) * (a * cosI + s2) + b2 * cosI * cosI;
  vec4 rp = rs * mix(vec4(1.0), above / max(below, 1e-30), vec4(greaterThan(below, vec4(0.0))));
  return min(0.5 * (rs + rp), 1.0);
}

// The frame of a facet, as the CPU backend's: its tangent is +x as seen along the facet.
mat3 brdfFrame(vec3 n)
{
  vec3 t = vec3(1.0, 0.0, 0.0) - n.x * n;
  t = dot(t, t) < 1e-10 ? vec3(0.0, 1.0, 0.0) - n.y * n : t;
  t = normalize(t);
  return mat3(t, cross(n, t), n);
}

void brdfLose(inout BrdfPath path)
{
  path.state |= BRDF_LOST;
}

// What goes on of the light, by channel; the rest is absorbed.
void brdfKeep(inout BrdfPath path, vec4 kept)
{
  path.absorbed += path.weight - kept;
  path.weight = kept;
}

void brdfAbsorbAlong(inout BrdfPath path, float distance)
{
  int medium = brdfMedium(path.media);
  if (medium < 0)
    return;
  vec4 depth = brdfMediumAbsorption[medium] * distance;
  vec4 share = mix(1.0 - exp(-depth), depth * (1.0 - 0.5 * depth * (1.0 - depth / 3.0)), vec4(lessThan(depth, vec4(0.01))));
  vec4 lost = path.weight * share;
  path.absorbed += lost;
  path.weight -= lost;
}

// Ends paths that carry little by chance.
void brdfRoulette(inout BrdfPath path)
{
  const float least = 0.01;
  float most = max(max(path.weight.x, path.weight.y), max(path.weight.z, path.weight.w));
  if (most >= least)
    return;
  bool survives = false;
  if (most > 0.0)
  {
    path.state |= BRDF_CHANCE;
    survives = brdfUnit(brdfRandom(path).x) * least < most;
  }
  path.weight = survives ? path.weight * (least / most) : vec4(0.0);
  path.state |= survives ? 0u : BRDF_ABSORBED;
}

// Where light meets an interface, it is split once; later one of both ways is drawn.
void brdfMeetDielectric(inout BrdfPath path, vec3 normal, int slot, bool front, float cosine)
{
  uvec2 behind = brdfChanged(path.media, slot, front);
  int from = brdfMedium(path.media), to = brdfMedium(behind);
  if (from == to)
  {
    path.media = behind;
    return;
  }
  float eta = brdfIndexOf(to).x / brdfIndexOf(from).x, cosT;
  float reflected = brdfDielectric(cosine, eta, cosT), refracted = 1.0 - reflected;
  bool refracts = refracted > 0.0;
  if (refracts && reflected > 0.0)
  {
    float most = max(max(path.weight.x, path.weight.y), max(path.weight.z, path.weight.w));
    if (brdfParts == 2 && (path.state & BRDF_SPLIT) == 0u && min(reflected, refracted) * most > 1e-3)
    {
      path.state |= BRDF_SPLIT;
      refracts = (path.state & BRDF_SECOND) != 0u;
      path.weight *= refracts ? refracted : reflected;
      path.absorbed = refracts ? vec4(0.0) : path.absorbed;
    }
    else
    {
      refracts = brdfUnit(brdfRandom(path).x) < refracted;
    }
  }
  vec3 n = front ? normal : -normal;
  if (refracts)
  {
    path.direction = normalize(path.direction / eta + (cosine / eta - cosT) * n);
    path.media = behind;
  }
  else
  {
    path.direction = normalize(path.direction + 2.0 * cosine * n);
  }
}

void brdfMeet(inout BrdfPath path, int facet, vec3 normal, bool front)
{
  vec4 head = texelFetch(brdfFacets, 3 * facet);
  int kind = int(head.x), slot = int(head.y);
  float cosine = min(abs(dot(path.direction, normal)), 1.0);
  path.meetings += 1u;
  // The back of what is opaque, or of a dielectric that was never entered: rounding let it through.
  bool inconsistent = !front && (kind != BRDF_DIELECTRIC || !brdfWithin(path.media, slot));
  if (inconsistent || path.meetings > uint(brdfBounces))
  {
    brdfLose(path);
    return;
  }
  if (kind == BRDF_DIELECTRIC)
  {
    brdfMeetDielectric(path, normal, slot, front, cosine);
    brdfRoulette(path);
    return;
  }
  if (kind == BRDF_MIRROR || kind == BRDF_CONDUCTOR)
  {
    if (kind == BRDF_CONDUCTOR)
    {
      vec4 outside = brdfIndexOf(brdfMedium(path.media));
      vec4 eta = texelFetch(brdfFacets, 3 * facet + 1) / outside, k = texelFetch(brdfFacets, 3 * facet + 2) / outside;
      brdfKeep(path, path.weight * brdfConductor(cosine, eta, k));
    }
    path.direction = normalize(path.direction + 2.0 * cosine * normal);
  }
  else
  {
    path.state |= BRDF_SCATTERED;
    uvec4 random = brdfRandom(path);
    vec2 u = vec2(brdfUnit(random.x), brdfUnit(random.y));
    mat3 frame = brdfFrame(normal);
#ifdef BRDF_SCATTERING
    if (kind != BRDF_LAMBERTIAN)
    {
      // Samplers draw a light for a viewer: here the known direction is the light, and stands in the viewer's place.
      vec3 light = -path.direction * frame, drawn = brdfMaterialSample(light, u);
      float density = drawn.z > 0.0 ? brdfMaterialPdf(drawn, light) : 0.0;
      bool failed = !(density > 0.0);
      brdfKeep(path, failed ? vec4(0.0) : path.weight * (brdfMaterialValue(light, drawn) * (drawn.z / density)));
      path.state |= BRDF_CHANCE;
      path.direction = failed ? path.direction : normalize(frame * drawn);
    }
    else
#endif
    {
      brdfKeep(path, path.weight * texelFetch(brdfFacets, 3 * facet + 1));
      float r = sqrt(u.x), angle = 6.28318531 * u.y;
      path.direction = normalize(frame * vec3(r * cos(angle), r * sin(angle), sqrt(1.0 - u.x)));
    }
  }
  brdfRoulette(path);
}

// The cosine and sine by which a ray turned the surface.
vec2 brdfTurn(uvec4 random)
{
  float angle = brdfTurning ? 6.28318531 * brdfUnit(random.z) : 0.0;
  return vec2(cos(angle), sin(angle));
}

BrdfPath brdfNew(int job)
{
  BrdfPath path;
  uint ray = uint(job / brdfParts);
  path.ray = uvec2(brdfFirst.x + ray, brdfFirst.y);
  path.ray.y += path.ray.x < ray ? 1u : 0u;
  path.weight = brdfBrought;
  path.absorbed = vec4(0.0);
  path.media = uvec2(0u);
  path.draws = 0u;
  path.place = 0u;
  path.meetings = 0u;
  path.searches = 0u;
  path.steps = 0u;
  path.state = (job & 1) == 1 && brdfParts == 2 ? BRDF_SECOND : 0u;
  path.position = vec3(0.0);
  path.direction = brdfIncident;
  return path;
}

out vec4 brdfPosition, brdfDirection, brdfWeight, brdfAbsorption;
out uvec4 brdfCount, brdfState;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  int job = at.y * brdfWidth + at.x;
  bool missing = job >= brdfJobs;
  if (!brdfBegin && !missing)
  {
    ivec2 from = ivec2(texelFetch(brdfSources, job).xy);
    at = ivec2(from.x % brdfWidth, from.x / brdfWidth);
    job = from.y;
  }
  BrdfPath path = brdfNew(job);
  uvec4 random = brdfPhilox(uvec4(path.ray, 0u, 0u), brdfSeed);
  vec2 turn = brdfTurn(random);
  if (brdfBegin)
  {
    brdfPutAbove(path, random);
    path.draws = 1u;
    path.direction.xy = vec2(turn.x * path.direction.x - turn.y * path.direction.y,
      turn.y * path.direction.x + turn.x * path.direction.y);
  }
  else
  {
    path.position = texelFetch(brdfPositions, at, 0).xyz;
    path.direction = texelFetch(brdfDirections, at, 0).xyz;
    path.weight = texelFetch(brdfWeights, at, 0);
    path.absorbed = texelFetch(brdfAbsorbed, at, 0);
    uvec4 counts = texelFetch(brdfCounts, at, 0), states = texelFetch(brdfStates, at, 0);
    path.media = counts.xy;
    path.draws = counts.z;
    path.place = counts.w;
    path.state = states.x;
    path.meetings = states.y;
    path.searches = states.z;
    path.steps = states.w;
  }
  path.state |= missing ? BRDF_LOST : 0u;
  int steps = brdfSteps;
  while ((path.state & BRDF_ENDED) == 0u && steps > 0)
  {
    float distance;
    int facet;
    vec3 normal;
    bool front;
    int before = steps;
    int end = brdfFollow(path, steps, distance, facet, normal, front);
    path.steps += uint(before - steps);
    brdfAbsorbAlong(path, distance);
    if (end == BRDF_FACET)
    {
      steps -= 16;  // what a meeting costs, and the turns of its loops
      path.steps = 0u;
      brdfMeet(path, facet, normal, front);
    }
    else if (end != BRDF_ON)
    {
      int medium = brdfMedium(path.media);
      bool consistent = end == BRDF_ABOVE ? medium < 0 : brdfTransmitsBelow(path.media);
      path.state |= !consistent ? BRDF_LOST : end == BRDF_ABOVE ? BRDF_LEFT_ABOVE : BRDF_LEFT_BELOW;
      path.state |= uint(medium + 1) << 12;
      // The surface turned back.
      path.direction.xy = vec2(turn.x * path.direction.x + turn.y * path.direction.y,
        turn.x * path.direction.y - turn.y * path.direction.x);
    }
    else if (path.steps > 1048576u)
    {
      brdfLose(path);  // meets nothing, ever
    }
  }
  brdfPosition = vec4(path.position, 0.0);
  brdfDirection = vec4(path.direction, 0.0);
  brdfWeight = path.weight;
  brdfAbsorption = path.absorbed;
  brdfCount = uvec4(path.media, path.draws, path.place);
  brdfState = uvec4(path.state, path.meetings, path.searches, path.steps);
}
