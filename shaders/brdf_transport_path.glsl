// A ray on its way through a microsurface, for every piece that moves it.
struct BrdfPath
{
  uvec2 ray;       // number, low and high word
  vec3 position;   // in the coordinates of the geometry
  vec3 direction;  // unit
  vec4 weight;     // what it carries, by channel
  vec4 absorbed;   // what it left behind
  uvec2 media;     // how often it is within each of eight dielectrics, a byte each
  uint draws;      // calls of the generator so far
  uint place;      // what the geometry keeps besides
  uint state;      // below
  uint meetings;   // with facets
  uint searches;   // for facets
  uint steps;      // since the last meeting
};

// How a path ended (none: it has not), and what happened to it.
const uint BRDF_ENDED = 7u, BRDF_LEFT_ABOVE = 1u, BRDF_LEFT_BELOW = 2u, BRDF_ABSORBED = 3u, BRDF_LOST = 4u;
const uint BRDF_SCATTERED = 8u;  // met more than mirrors
const uint BRDF_CHANCE = 16u;    // its weight was divided by a chance
const uint BRDF_SPLIT = 32u;
const uint BRDF_SECOND = 64u;  // is the refracted part
const uint BRDF_ON_LOWER = 128u, BRDF_ON_UPPER = 256u;  // starts on this triangle of a cell
// From bit 12 on: 1 + the medium in which it ended, 0 for none.

// What following a ray comes to.
const int BRDF_ON = 0, BRDF_FACET = 1, BRDF_ABOVE = 2, BRDF_BELOW = 3;

const float BRDF_NEVER = 1e30;

uniform int brdfBelow;  // medium in which transmitted light leaves; -1: none (opaque); -2: any, the surface has holes

// High and low word of a product.
uvec2 brdfProduct(uint a, uint b)
{
  uint low = (a & 0xffffu) * (b & 0xffffu);
  uint middle = (a >> 16) * (b & 0xffffu) + (low >> 16);
  uint other = (a & 0xffffu) * (b >> 16) + (middle & 0xffffu);
  return uvec2((a >> 16) * (b >> 16) + (middle >> 16) + (other >> 16), a * b);
}

// Four random words of a counter under a key: Philox4x32-10 of Salmon, Moraes, Dror, Shaw 2011, "Parallel random
// numbers: as easy as 1, 2, 3", section 3.3, DOI 10.1145/2063384.2063405.
uvec4 brdfPhilox(uvec4 counter, uvec2 key)
{
  for (int round = 0; round < 10; ++round)
  {
    uvec2 high0 = brdfProduct(0xd2511f53u, counter.x), high1 = brdfProduct(0xcd9e8d57u, counter.z);
    counter = uvec4(high1.x ^ counter.y ^ key.x, high1.y, high0.x ^ counter.w ^ key.y, high0.y);
    key += uvec2(0x9e3779b9u, 0xbb67ae85u);
  }
  return counter;
}

// In [0, 1).
float brdfUnit(uint random)
{
  return float(random >> 8) * 5.9604644775390625e-8;
}

bool brdfWithin(uvec2 media, int slot)
{
  uint word = slot < 4 ? media.x : media.y;
  return slot >= 0 && (word >> uint(8 * (slot & 3)) & 255u) != 0u;
}

// The dielectric that rules, or -1: the first of those that the ray is within.
int brdfMedium(uvec2 media)
{
  if ((media.x | media.y) == 0u)
    return -1;
  uint word = media.x != 0u ? media.x : media.y;
  int slot = (word & 255u) != 0u ? 0 : (word & 65535u) != 0u ? 1 : (word & 16777215u) != 0u ? 2 : 3;
  return media.x != 0u ? slot : 4 + slot;
}

// After entering a dielectric, or leaving it.
uvec2 brdfChanged(uvec2 media, int slot, bool enters)
{
  uint shift = uint(8 * (slot & 3)), word = slot < 4 ? media.x : media.y;
  uint count = word >> shift & 255u;
  uint changed = enters ? (count < 255u ? word + (1u << shift) : word) : (count > 0u ? word - (1u << shift) : word);
  return slot < 4 ? uvec2(changed, media.y) : uvec2(media.x, changed);
}

bool brdfTransmitsBelow(uvec2 media)
{
  return brdfBelow == -2 || brdfWithin(media, brdfBelow);
}
