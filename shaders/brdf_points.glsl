// Points to draw with: random words and a low-discrepancy sequence, another one for every pixel.

// Two independent random words from two words: M. Jarzynski and M. Olano, "Hash Functions for GPU Rendering", JCGT 9(3),
// 2020, pcg2d.
uvec2 brdfHash(uvec2 v)
{
  v = v * 1664525u + 1013904223u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  return v;
}

uint brdfReversed(uint x)
{
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
  x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
  return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

// Nested uniform scrambling of a number whose digits are reversed (S. Laine and T. Karras 2011, "Stratified Sampling for
// Stochastic Transparency", as B. Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4), uses it): every digit
// is flipped by a hash of those before it.
uint brdfScrambled(uint x, uint seed)
{
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return x;
}

// In [0, 1).
float brdfFraction(uint x)
{
  return float(x >> 8u) * (1.0 / 16777216.0);
}

// Point i of the Sobol sequence of two dimensions (I. Sobol 1967), scrambled: any 2^k points from a multiple of 2^k on
// have one in each of the 2^k boxes of every shape 2^-j x 2^(j-k).
vec2 brdfSobolPoint(uint i, uvec2 seed)
{
  uint second = 0u;  // the second coordinate, its digits reversed; those of the first are i's own
  for (uint rest = i, v = 1u; rest != 0u; rest >>= 1, v ^= v << 1)
    if ((rest & 1u) != 0u)
      second ^= v;
  return vec2(brdfFraction(brdfReversed(brdfScrambled(i, seed.x))),
              brdfFraction(brdfReversed(brdfScrambled(second, seed.y))));
}

// Independent points, uniform.
vec2 brdfRandomPoint(uint i, uvec2 seed)
{
  uvec2 words = brdfHash(seed + uvec2(i * 0x9e3779b9u, i));
  return vec2(brdfFraction(words.x), brdfFraction(words.y));
}
