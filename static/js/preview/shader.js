/**
 * The scene: a ball over water with a checkered floor, two matte balls in it, a sky. Each surface is
 * drawn by a fragment shader of its own over the rectangle that holds it, with no branch that a software
 * renderer would have to walk on both sides. Reflectance is read from textures that hold the server's
 * curves; there is no formula of R here. Light is linear until it is presented.
 */

/** Intervals of a curve's texture over cos(theta_i), which has a texel more. */
export const INTERVALS = 1024;
/** Rows of that texture: R of both sides and of water, T of both sides. */
export const ROWS = { left: 0, right: 1, water: 2, left_T: 3, right_T: 4 };
/** What a texel holds where the model is undefined. */
export const UNDEFINED = 1e9;
/** Radiance of the even light, in every channel. */
export const EVEN = 0.8;
/** How R is evaluated. */
export const HOW = { pixel: 0, vertex: 1, texture: 2 };
/** What is below the chosen surface. */
export const BODY = { opaque: 0, clear: 1, paint: 2 };

/** Centers and radii. */
export const BALLS = {
  ball: { center: [0, 1.12, 0], radius: 1 },
  buoy: { center: [-2.1, 0.12, -2.3], radius: 0.62 },
  stone: { center: [1.9, 0, -1.5], radius: 0.45 },
};

export const VERTEX = `#version 300 es
void main() {
  // One triangle that covers the picture; scissors cut it.
  gl_Position = vec4(4.0 * float(gl_VertexID & 1) - 1.0, 2.0 * float(gl_VertexID & 2) - 1.0, 0.0, 1.0);
}`;

/** @param {number} x */
const float = (x) => (Number.isInteger(x) ? x.toFixed(1) : String(x));
/** @param {{center: number[], radius: number}} ball */
const ballOf = ({ center, radius }) => `vec4(${[...center, radius].map(float).join(", ")})`;

/** sRGB's encoding of linear light. */
const ENCODED = `
vec3 encoded(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
`;

const COMMON = `
precision highp float;
precision highp sampler2D;
const int LAST = ${INTERVALS};
const int WATER = ${ROWS.water};
const int T_BELOW_R = ${ROWS.left_T - ROWS.left};
const float UNDEFINED = ${UNDEFINED.toExponential()};
const vec3 EVEN = vec3(${float(EVEN)});

const vec4 BALL = ${ballOf(BALLS.ball)};
const vec4 BUOY = ${ballOf(BALLS.buoy)};
const vec4 STONE = ${ballOf(BALLS.stone)};
const float DEPTH = 1.5;
const float WATER_ETA = 0.75;
// Meshes for R per vertex: parts of an octahedron's edge, and the side of the water's cells.
const float PARTS = 4.0;
const float CELL = 2.5;

const vec3 SUN = normalize(vec3(-0.76, 0.46, -0.10));
const vec3 SUN_BELOW = normalize(vec3(-0.6376, 0.7658, -0.0839)); // refracted by water of n = 4/3
const vec3 SUNLIGHT = vec3(0.85, 0.73, 0.56); // irradiance over pi
const vec3 SKYLIGHT = vec3(0.50, 0.62, 0.80);

uniform vec2 u_size;
uniform mat3 u_camera;     // right, up, forward
uniform vec3 u_eye;
uniform float u_lens;      // tangent of half the angle that the shorter side sees
uniform int u_row;         // of the side's curve
uniform float u_texels;
uniform sampler2D u_curves;
uniform sampler2D u_table;
uniform float u_eta;       // n_i / n_t
uniform vec3 u_escape;     // of the light in the paint the share that comes out again, over 1 - u_external
uniform float u_external;  // albedo of the surface for diffuse light
out vec4 color;
${ENCODED}
/** Write linear light, or what the screen takes where there is nothing to be done with it any more. */
void put(vec3 c, float cover, float alpha) {
#ifdef ENCODE
  c = encoded(c);
#endif
  color = vec4(min(c, 4.0) * cover, alpha);
}

float pixelAngle() { return 2.0 * u_lens / min(u_size.x, u_size.y); }

vec3 direction() {
  vec2 q = (2.0 * gl_FragCoord.xy - u_size) / min(u_size.x, u_size.y) * u_lens;
  return normalize(u_camera * vec3(q, 1.0));
}

vec3 sky(vec3 d) {
#ifdef EVEN_LIGHT
  return EVEN;
#else
  float up = max(d.y, 0.0);
  float low = 1.0 - up;
  float low2 = low * low, low4 = low2 * low2, low8 = low4 * low4;
  vec3 c = mix(vec3(0.070, 0.150, 0.330), vec3(0.270, 0.400, 0.600), low2);
  float s = max(dot(d, SUN), 0.0);
  float s2 = s * s, s4 = s2 * s2, s8 = s4 * s4, s32 = s8 * s8 * s8 * s8;
  c = mix(c, mix(vec3(0.74, 0.72, 0.70), vec3(1.00, 0.79, 0.52), s4), low8 * (0.75 + 0.25 * low8));
  c += vec3(0.16, 0.11, 0.05) * s8 + vec3(0.30, 0.22, 0.12) * s32 * s32;
  return c + vec3(3.0, 2.7, 2.2) * smoothstep(0.9990, 0.9995, s);
#endif
}

vec3 matte(vec3 N, vec3 albedo) {
#ifdef EVEN_LIGHT
  return albedo * EVEN;
#else
  return albedo * (SUNLIGHT * max(dot(N, SUN), 0.0) + SKYLIGHT * (0.62 + 0.38 * N.y));
#endif
}

vec3 buoy(vec3 N) {
  return matte(N, mix(vec3(0.78, 0.76, 0.70), vec3(0.72, 0.16, 0.08), smoothstep(0.30, 0.33, N.y)));
}
vec3 stone(vec3 N) { return matte(N, vec3(0.86, 0.62, 0.20)); }

const float FAR = 1e6;

/** Where a ball is hit, or FAR. */
float hit(vec3 from, vec3 d, vec4 ball) {
  vec3 away = from - ball.xyz;
  float b = dot(away, d);
  float h = b * b - dot(away, away) + ball.w * ball.w;
  float t = -b - sqrt(max(h, 0.0));
  return h > 0.0 && t > 0.0 ? t : FAR;
}

/** The matte balls, if they are nearer than what has been seen. */
void things(vec3 from, vec3 d, inout float nearest, inout vec3 c) {
  float t = hit(from, d, BUOY);
  c = t < nearest ? buoy((from + t * d - BUOY.xyz) / BUOY.w) : c;
  nearest = min(nearest, t);
  t = hit(from, d, STONE);
  c = t < nearest ? stone((from + t * d - STONE.xyz) / STONE.w) : c;
  nearest = min(nearest, t);
}

/** Squares of side 1, averaged over a rectangle. */
float checkers(vec2 p, vec2 size) {
  vec2 w = max(size, 1e-3);
  vec2 i = 2.0 * (abs(fract((p - 0.5 * w) * 0.5) - 0.5) - abs(fract((p + 0.5 * w) * 0.5) - 0.5)) / w;
  return 0.5 - 0.5 * i.x * i.y;
}

/** The floor below the water in a direction, for a ray that came down at a slope; and how far it is. */
vec3 ground(vec3 from, vec3 d, float way, float slope, out float t) {
  t = (from.y + DEPTH) / max(-d.y, 0.02);
  vec3 p = from + t * d;
  // A pixel is seen on the water as a stripe toward the horizon.
  vec2 ahead = abs(d.xz) * inversesqrt(max(dot(d.xz, d.xz), 1e-6));
  vec2 size = pixelAngle() * (way + t) * (1.0 + ahead / max(slope, 1e-2));
  float squares = checkers(p.xz * 0.8, 0.8 * size);
  vec3 albedo = mix(vec3(0.15, 0.18, 0.19), vec3(0.66, 0.63, 0.55), squares);
  // The ball's shadow: from the floor along the refracted ray to the surface, then toward the sun.
  vec3 toward = BALL.xyz - p - SUN_BELOW * (DEPTH / SUN_BELOW.y);
  float along = dot(toward, SUN);
  float sun = smoothstep(0.72, 1.36, dot(toward, toward) - along * along);
  return albedo * (SUNLIGHT * sun + 0.55 * SKYLIGHT);
}

/** What the water leaves of the light over a way. */
vec3 murk(float t) {
  float c = exp(-0.075 * min(t, 12.0));
  float red = c * c;
  return vec3(red * red, c, c);
}

vec3 ripples(vec3 p, float way) {
  float steep = 0.016 / (1.0 + 0.024 * way * way);
  float a = cos(dot(p.xz, vec2(3.1, 1.7)));
  float b = cos(dot(p.xz, vec2(-1.9, 4.3)) + 1.0);
  return normalize(vec3(-steep * (a - 0.6 * b), 1.0, -steep * (0.6 * a + b)));
}

vec3 curve(int row, float mu) {
  float at = clamp(mu, 0.0, 1.0) * float(LAST);
  int i = min(int(at), LAST - 1);
  vec3 a = texelFetch(u_curves, ivec2(i, row), 0).rgb;
  vec3 b = texelFetch(u_curves, ivec2(i + 1, row), 0).rgb;
#ifdef HOLES
  if (max(a.r, b.r) >= UNDEFINED) return vec3(UNDEFINED);
#endif
  return mix(a, b, at - float(i));
}

/** R of water, from one texel: its red is the value, its green that of the next. */
vec3 waterR(float mu) {
  float at = clamp(mu, 0.0, 1.0) * float(LAST);
  int i = min(int(at), LAST - 1);
  vec2 ends = texelFetch(u_curves, ivec2(i, WATER), 0).rg;
  return vec3(mix(ends.x, ends.y, at - float(i)));
}

/** R of the chosen interface. */
vec3 R(float mu) {
#if HOW == ${HOW.texture}
  // The texels' centers are at (j + 1/2) / N.
  vec2 at = vec2((clamp(mu, 0.0, 1.0) * (u_texels - 1.0) + 0.5) / u_texels, 0.5);
  return texture(u_table, at).rgb;
#else
  return curve(u_row, mu);
#endif
}

/** What the chosen interface lets through: all that it does not reflect, unless films absorb. */
vec3 T(float mu, vec3 r) {
#ifdef OWN_T
  return curve(u_row + T_BELOW_R, clamp(mu, 0.0, 1.0));
#else
  return 1.0 - r;
#endif
}

/** Shirley's mix, color = T x refracted + R x reflected; hatched where there is no R. */
vec3 mixed(vec3 r, vec3 t, vec3 refracted, vec3 reflected) {
#ifdef HOLES
  if (r.r >= UNDEFINED)
    return fract((gl_FragCoord.x + gl_FragCoord.y) / 12.0) < 0.5 ? vec3(0.6, 0.05, 0.4) : vec3(0.25, 0.0, 0.18);
#endif
  return t * refracted + r * reflected;
}

/** The paint under the surface: light comes in through it from everywhere, and goes out through it. */
vec3 paint(vec3 N) {
#ifdef EVEN_LIGHT
  return EVEN * (1.0 - u_external) * u_escape;
#else
  float mu = dot(N, SUN);
  vec3 entering = mu > 0.0 ? clamp(1.0 - R(mu), 0.0, 1.0) : vec3(0.0);
  return (SUNLIGHT * max(mu, 0.0) * entering + SKYLIGHT * (0.62 + 0.38 * N.y) * (1.0 - u_external)) * u_escape;
#endif
}

/** R at a vertex of a mesh. */
vec3 atVertex(vec3 p, vec3 N) { return curve(u_row, dot(N, normalize(u_eye - p))); }
`;

const SKY = `
void main() { put(sky(direction()), 1.0, 0.0); }`;

const THING = `
uniform int u_thing;
void main() {
  vec4 ball = u_thing == 0 ? BUOY : STONE;
  vec3 d = direction(), away = u_eye - ball.xyz;
  float b = dot(away, d);
  float h = b * b - dot(away, away) + ball.w * ball.w;
  float edge = ball.w * pixelAngle() * -b * 2.0;
  vec3 p = u_eye - d * (b + sqrt(max(h, 0.0)));
  vec3 N = normalize(p - ball.xyz);
  float cover = clamp(0.5 + h / edge, 0.0, 1.0) * clamp(0.5 + p.y / (pixelAngle() * -b), 0.0, 1.0);
  put(u_thing == 0 ? buoy(N) : stone(N), cover, cover);
}`;

const AROUND = `
/** What the ball shows of what is around it in a direction. */
vec3 around(vec3 from, vec3 d, float way) {
#ifdef EVEN_LIGHT
  return EVEN;
#else
  float t = min(from.y / max(-d.y, 1e-3), 400.0);
  vec3 p = from + t * d;
  float far = way + 3.0 * t; // a curved mirror spreads the pixel
  float deep;
#ifdef WATER_CHOSEN
  vec3 r = R(-d.y), through = T(-d.y, r);
  vec3 b = refract(d, vec3(0.0, 1.0, 0.0), u_eta);
#else
  vec3 r = waterR(-d.y), through = 1.0 - r;
  vec3 b = refract(d, vec3(0.0, 1.0, 0.0), WATER_ETA);
#endif
  vec3 c = sky(vec3(d.x, abs(d.y), d.z));
  vec3 floored = ground(p, b, far, -d.y, deep);
  c = d.y < 0.0 ? mixed(r, through, floored * murk(deep), c) : c;
  float nearest = d.y < 0.0 ? t : FAR;
  things(from, d, nearest, c);
  return c;
#endif
}
`;

const BALL_PASS = `${AROUND}
#if HOW == ${HOW.vertex}
/** R at the corners of a triangle of an octahedron, subdivided and pushed out to the ball, between them. */
vec3 meshed(vec3 N) {
  vec3 signs = vec3(N.x < 0.0 ? -1.0 : 1.0, N.y < 0.0 ? -1.0 : 1.0, N.z < 0.0 ? -1.0 : 1.0);
  vec3 b = abs(N) * (PARTS / dot(abs(N), vec3(1.0)));
  vec3 i = min(floor(b), PARTS - 1.0);
  vec3 f = b - i;
  bool upright = f.x + f.y + f.z < 1.5;
  vec3 w = upright ? f : 1.0 - f;
  vec3 c = upright ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 1.0);
  vec3 A = i + c, B = i + c.zxy, C = i + c.yzx;
  // Weights in the flat triangle between the corners, seen from the center.
  w *= vec3(length(A), length(B), length(C));
  A = signs * normalize(A);
  B = signs * normalize(B);
  C = signs * normalize(C);
  return (w.x * atVertex(BALL.xyz + A, A) + w.y * atVertex(BALL.xyz + B, B) + w.z * atVertex(BALL.xyz + C, C))
    / (w.x + w.y + w.z);
}
#endif

void main() {
  vec3 d = direction(), away = u_eye - BALL.xyz;
  float b = dot(away, d);
  float h = b * b - dot(away, away) + 1.0;
  float t = -b - sqrt(max(h, 0.0));
  vec3 p = u_eye + t * d;
  vec3 N = normalize(p - BALL.xyz);
  float mu = clamp(-dot(d, N), 0.0, 1.0);
  float cover = clamp(0.5 - 0.5 * h / (pixelAngle() * b), 0.0, 1.0);
#ifdef WATER_CHOSEN
  vec3 c = matte(N, vec3(0.80, 0.24, 0.12));
#else
#if HOW == ${HOW.vertex}
  vec3 r = meshed(N);
#else
  vec3 r = R(mu);
#endif
  vec3 through = T(mu, r);
  vec3 inner = vec3(0.0);
#if BODY == ${BODY.paint}
  inner = paint(N);
#elif BODY == ${BODY.clear}
  vec3 inside = refract(d, N, u_eta);
  vec3 q = p - 2.0 * dot(inside, N) * inside;
  vec3 leaving = refract(inside, BALL.xyz - q, 1.0 / u_eta);
  // At both ends of a chord the angles are the same: as much is let out as was let in.
  inner = dot(leaving, leaving) > 0.5 ? through * around(q, leaving, t + 4.0) : vec3(0.0);
#endif
  vec3 c = mixed(r, through, inner, around(p, reflect(d, N), t));
#endif
  put(c, cover, cover);
}`;

const WATER_PASS = `
#if HOW == ${HOW.vertex}
/** R at the corners of a triangle of a square grid, between them. */
vec3 meshed(vec3 p) {
  vec2 q = p.xz / CELL;
  vec2 f = fract(q);
  bool lower = f.x + f.y < 1.0;
  vec2 w = lower ? f : 1.0 - f;
  vec2 a = floor(q) + (lower ? vec2(0.0) : vec2(1.0));
  float turn = lower ? 1.0 : -1.0;
  vec3 A = CELL * vec3(a.x, 0.0, a.y), B = A + vec3(turn * CELL, 0.0, 0.0), C = A + vec3(0.0, 0.0, turn * CELL);
  return (1.0 - w.x - w.y) * atVertex(A, ripples(A, distance(A, u_eye)))
    + w.x * atVertex(B, ripples(B, distance(B, u_eye)))
    + w.y * atVertex(C, ripples(C, distance(C, u_eye)));
}
#endif

#ifndef PLAIN
/** What the ball shows in the water: the sky in it, or through it. */
vec3 mirrored(vec3 p, vec3 d) {
  vec3 N = p - BALL.xyz;
#ifdef WATER_CHOSEN
  return matte(N, vec3(0.80, 0.24, 0.12));
#else
  vec3 m = reflect(d, N);
  vec3 dim = vec3(0.16, 0.22, 0.24);
  vec3 reflected = mix(dim, sky(m), smoothstep(-0.25, 0.1, m.y));
  vec3 inner = vec3(0.0);
#if BODY == ${BODY.paint}
  inner = paint(N);
#elif BODY == ${BODY.clear}
  vec3 inside = refract(d, N, u_eta);
  vec3 leaving = reflect(-inside, normalize(inside - 0.6 * N));
  inner = mix(dim, sky(leaving), smoothstep(-0.25, 0.1, leaving.y));
#endif
  float mu = clamp(-dot(d, N), 0.0, 1.0);
  vec3 r = R(mu);
  return mixed(r, T(mu, r), inner, reflected);
#endif
}
#endif

void main() {
  vec3 d = direction();
  float way = u_eye.y / max(-d.y, 1e-4);
  vec3 p = u_eye + way * d;
  vec3 N = ripples(p, way);
  float mu = max(-dot(d, N), 0.0);
#ifndef WATER_CHOSEN
  vec3 r = waterR(mu);
  vec3 through = 1.0 - r;
  vec3 b = refract(d, N, WATER_ETA);
#else
  vec3 b = refract(d, N, u_eta);
#if HOW == ${HOW.vertex}
  vec3 r = meshed(p);
#else
  vec3 r = R(mu);
#endif
  vec3 through = T(mu, r);
#endif
  vec3 inner = vec3(0.0);
#if !defined(WATER_CHOSEN) || BODY == ${BODY.clear}
  float deep;
  inner = ground(p, b, way, -d.y, deep);
#ifndef PLAIN
  things(p, b, deep, inner);
#endif
  inner = b.y < 0.0 ? inner * murk(deep) : vec3(0.0);
#endif
  vec3 up = reflect(d, N);
  up.y = abs(up.y);
  vec3 reflected = sky(up);
#ifndef PLAIN
  float nearest = hit(p, up, BALL);
  reflected = nearest < FAR ? mirrored(p + nearest * up, up) : reflected;
  things(p, up, nearest, reflected);
#endif
  put(mixed(r, through, inner, reflected), 1.0, WATER_MASK);
}`;

const PRESENT = `
precision highp float;
precision highp sampler2D;
uniform sampler2D u_left;
uniform sampler2D u_right;
uniform vec2 u_size;
uniform float u_gain;
out vec4 color;
${ENCODED}
/** Darker on the right is blue, brighter is orange; black is the same. */
vec3 scale(float x) {
  float size = clamp(abs(x), 0.0, 1.0);
  vec3 full = x < 0.0 ? vec3(0.28, 0.66, 1.0) : vec3(1.0, 0.60, 0.18);
  return size < 0.6 ? mix(vec3(0.035, 0.045, 0.06), full, size / 0.6) : mix(full, vec3(1.0), (size - 0.6) / 0.4);
}

void main() {
  vec2 at = gl_FragCoord.xy / u_size;
#ifdef DIFFERENCE
  vec4 a = texture(u_left, at), b = texture(u_right, at);
  vec3 d = encoded(b.rgb) - encoded(a.rgb);
  float largest = abs(d.r) > abs(d.g) ? d.r : d.g;
  largest = abs(d.b) > abs(largest) ? d.b : largest;
  color = vec4(scale(largest * u_gain), a.a);
#else
  vec4 one = texture(u_left, at);
  color = vec4(encoded(one.rgb), one.a);
#endif
}`;

/**
 * @typedef {object} Variant what is decided before a shader is compiled
 * @property {number} how
 * @property {number} body
 * @property {boolean} water whether the water, in place of the ball, has the chosen interface
 * @property {boolean} even
 * @property {boolean} holes whether the model is undefined somewhere
 * @property {boolean} own_t whether what is let through is known apart from what is reflected
 */

/** @type {Record<string, string>} */
const PASSES = { sky: SKY, water: WATER_PASS, ball: BALL_PASS, thing: THING };

/**
 * The source of a surface's fragment shader.
 * @param {string} pass
 * @param {Variant} variant
 * @param {{plain?: boolean, encode?: boolean}} [how] plain water has no balls in or above it; what is encoded is for the screen
 */
export function surface(
  pass,
  { how, body, water, even, holes, own_t },
  { plain = false, encode = false } = {},
) {
  const flags = {
    WATER_CHOSEN: water,
    EVEN_LIGHT: even,
    HOLES: holes,
    OWN_T: own_t,
    PLAIN: plain,
    ENCODE: encode,
  };
  return [
    "#version 300 es",
    `#define HOW ${how}`,
    `#define BODY ${body}`,
    `#define WATER_MASK ${water ? "1.0" : "0.0"}`,
    ...Object.entries(flags).flatMap(([name, on]) => (on ? [`#define ${name}`] : [])),
    COMMON,
    PASSES[pass],
  ].join("\n");
}

/** The source of what brings linear pictures onto the screen: one, or the difference of two. @param {boolean} difference */
export function presenter(difference) {
  return ["#version 300 es", difference ? "#define DIFFERENCE" : "", PRESENT].join("\n");
}
