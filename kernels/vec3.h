// Vectors and complex numbers over lanes.
#ifndef NICOL_VEC3_H
#define NICOL_VEC3_H
#include "portable.h"

typedef struct { real x, y, z; } vec3;
typedef struct { real re, im; } cplx;
typedef struct { vec3 re, im; } cvec3;

FUNCTION vec3 vec(real x, real y, real z) { vec3 v; v.x = x; v.y = y; v.z = z; return v; }
FUNCTION vec3 broadcast(GLOBAL const scalar* p) { return vec(lanes(p[0]), lanes(p[1]), lanes(p[2])); }
FUNCTION real dot3(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FUNCTION vec3 cross3(vec3 a, vec3 b) {
  return vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
FUNCTION vec3 scale3(real s, vec3 a) { return vec(s * a.x, s * a.y, s * a.z); }
FUNCTION vec3 add3(vec3 a, vec3 b) { return vec(a.x + b.x, a.y + b.y, a.z + b.z); }
FUNCTION vec3 sub3(vec3 a, vec3 b) { return vec(a.x - b.x, a.y - b.y, a.z - b.z); }
// b + s a
FUNCTION vec3 along(real s, vec3 a, vec3 b) { return vec(s * a.x + b.x, s * a.y + b.y, s * a.z + b.z); }
FUNCTION vec3 pick3(mask m, vec3 a, vec3 b) {
  return vec(pick(m, a.x, b.x), pick(m, a.y, b.y), pick(m, a.z, b.z));
}
FUNCTION vec3 unit3(vec3 a) { return scale3(lanes(1) / sqrt_of(dot3(a, a)), a); }
// Pulls a vector that is unit but for rounding back to unit length (one Newton step of 1/sqrt). What is missing is added: a factor
// next to 1 would be rounded itself, one way, and a thousand faces would add that up.
FUNCTION vec3 renew_unit(vec3 a) { return along(lanes(0.5) - lanes(0.5) * dot3(a, a), a, a); }

FUNCTION cplx complex_of(real re, real im) { cplx c; c.re = re; c.im = im; return c; }
FUNCTION cplx cadd(cplx a, cplx b) { return complex_of(a.re + b.re, a.im + b.im); }
FUNCTION cplx csub(cplx a, cplx b) { return complex_of(a.re - b.re, a.im - b.im); }
FUNCTION cplx cmul(cplx a, cplx b) {
  return complex_of(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}
FUNCTION cplx cscale(real s, cplx a) { return complex_of(s * a.re, s * a.im); }
FUNCTION cplx conj_of(cplx a) { return complex_of(a.re, -a.im); }
FUNCTION real norm2(cplx a) { return a.re * a.re + a.im * a.im; }
FUNCTION cplx cdiv(cplx a, cplx b) {
  real inverse = lanes(1) / norm2(b);
  return complex_of((a.re * b.re + a.im * b.im) * inverse, (a.im * b.re - a.re * b.im) * inverse);
}
FUNCTION cplx cpick(mask m, cplx a, cplx b) {
  return complex_of(pick(m, a.re, b.re), pick(m, a.im, b.im));
}
// The same for a complex number of length 1.
FUNCTION cplx renew_phase(cplx a) {
  real missing = lanes(0.5) - lanes(0.5) * norm2(a);
  return complex_of(a.re + missing * a.re, a.im + missing * a.im);
}
// The square root with Re >= 0; on the negative real axis the one with Im > 0.
FUNCTION cplx csqrt_of(cplx a) {
  real length = sqrt_of(norm2(a));
  real big = sqrt_of(lanes(0.5) * (length + abs_of(a.re)));
  real small = pick(big > lanes(0), lanes(0.5) * abs_of(a.im) / pick(big > lanes(0), big, lanes(1)), lanes(0));
  real re = pick(a.re >= lanes(0), big, small);
  real im = pick(a.re >= lanes(0), small, big);
  return complex_of(re, pick(a.im < lanes(0), -im, im));
}

#endif
