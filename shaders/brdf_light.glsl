// The equirectangular map itself, read as brdf::EnvironmentMap::radiance reads it, and its own density, as
// brdf::EnvironmentSampler: for light that is not filtered. Directions are unit and in coordinates of the map.
uniform sampler2D brdfLightPicture;  // R, G, B: radiance; A: share of the row's light in its columns so far, up to 1
uniform sampler2D brdfLightRows;     // A: share of the light in the rows so far, up to 1

// Columns from the left and rows from the top, as fractions of the picture. The drivers' acos is off by 2e-4.
vec2 brdfLightPlace(vec3 d)
{
  return vec2(0.5 + brdf_atan2(d.x, -d.z) / (2.0 * BRDF_PI), brdf_atan2(length(d.xz), d.y) / BRDF_PI);
}

// Bilinear, in full precision (texture units interpolate with 8 bits); across a pole the opposite meridian continues.
vec3 brdfLight(vec3 d)
{
  ivec2 size = textureSize(brdfLightPicture, 0);
  vec2 place = brdfLightPlace(d) * vec2(size) - 0.5;
  vec2 corner = floor(place);
  vec2 part = place - corner;
  vec3 rows[2];
  for (int k = 0; k < 2; ++k)
  {
    ivec2 at = ivec2(corner) + ivec2(0, k);
    bool over = at.y < 0 || at.y >= size.y;
    at.y = clamp(at.y, 0, size.y - 1);
    at.x += size.x + (over ? size.x / 2 : 0);
    rows[k] = mix(texelFetch(brdfLightPicture, ivec2(at.x % size.x, at.y), 0).rgb,
                  texelFetch(brdfLightPicture, ivec2((at.x + 1) % size.x, at.y), 0).rgb, part.x);
  }
  return mix(rows[0], rows[1], part.y);
}

// Half the sine of the half angle squared is what is even in solid angle: at the upper edge of a row.
float brdfLightEdge(int row, int rows)
{
  float s = sin(0.5 * BRDF_PI * float(row) / float(rows));
  return s * s;
}

float brdfLightShare(sampler2D shares, ivec2 at)
{
  float below = at.x > 0 ? texelFetch(shares, at - ivec2(1, 0), 0).a : 0.0;
  return texelFetch(shares, at, 0).a - below;
}

// Density (1/sr) of drawing a direction inside a texel.
float brdfLightDensity(ivec2 texel, ivec2 size)
{
  float angle = brdfLightEdge(texel.y + 1, size.y) - brdfLightEdge(texel.y, size.y);  // of the row, over 4 pi
  return brdfLightShare(brdfLightRows, ivec2(texel.y, 0)) * brdfLightShare(brdfLightPicture, texel) * float(size.x) /
         (4.0 * BRDF_PI * angle);
}

float brdfLightPdf(vec3 d)
{
  ivec2 size = textureSize(brdfLightPicture, 0);
  return brdfLightDensity(min(ivec2(brdfLightPlace(d) * vec2(size)), size - 1), size);
}

// The interval of a row of shares that holds u, and where in it.
int brdfLightFind(sampler2D shares, int row, int count, float u, out float part)
{
  int low = 0, high = count - 1;
  while (low < high)
  {
    int middle = (low + high) / 2;
    if (texelFetch(shares, ivec2(middle, row), 0).a > u)
      high = middle;
    else
      low = middle + 1;
  }
  float below = low > 0 ? texelFetch(shares, ivec2(low - 1, row), 0).a : 0.0;
  float share = texelFetch(shares, ivec2(low, row), 0).a - below;
  part = share > 0.0 ? clamp((u - below) / share, 0.0, 1.0) : 0.5;
  return low;
}

// A direction in proportion to the light, and its density.
vec3 brdfLightSample(vec2 u, out float density)
{
  ivec2 size = textureSize(brdfLightPicture, 0);
  vec2 part;
  ivec2 texel;
  texel.y = brdfLightFind(brdfLightRows, 0, size.y, u.y, part.y);
  texel.x = brdfLightFind(brdfLightPicture, texel.y, size.x, u.x, part.x);
  density = brdfLightDensity(texel, size);
  float phi = 2.0 * BRDF_PI * ((float(texel.x) + part.x) / float(size.x) - 0.5);
  float t = mix(brdfLightEdge(texel.y, size.y), brdfLightEdge(texel.y + 1, size.y), part.y);
  float sine = 2.0 * sqrt(t * (1.0 - t));
  return vec3(sine * sin(phi), 1.0 - 2.0 * t, -sine * cos(phi));
}
