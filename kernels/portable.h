// The only file that knows the difference between OpenCL C 1.2 and C++17, and between one lane and many.
// Set by the build: LANES (1, 4, 8, 16), REAL_DOUBLE (defined: fp64), SCENE_FEATURES (mask; undefined: generic).
//   scalar  float or double          real      LANES scalars, one per lane
//   mask    result of comparing reals lane_int  an integer per lane, as wide as scalar
// pick(m, a, b) takes a where m holds, b elsewhere, lane by lane.
#ifndef NICOL_PORTABLE_H
#define NICOL_PORTABLE_H

#ifndef LANES
#define LANES 1
#endif

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)

#ifdef __OPENCL_C_VERSION__
#ifdef REAL_DOUBLE
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
typedef double scalar;
typedef long scalar_int;
#define SCALAR_NAME double
#define SCALAR_INT_NAME long
#else
typedef float scalar;
typedef int scalar_int;
#define SCALAR_NAME float
#define SCALAR_INT_NAME int
#endif
#define GLOBAL __global
#define PRIVATE __private
#define FUNCTION static inline
#if LANES == 1
typedef scalar real;
typedef int mask;
typedef int lane_int;
#define any_lane(m) (m)
#define load_lanes(p) (*(p))
#define store_lanes(v, p) (*(p) = (v))
#define to_lane_int(m) (m)
#else
typedef JOIN(SCALAR_NAME, LANES) real;
typedef JOIN(SCALAR_INT_NAME, LANES) mask;
typedef JOIN(SCALAR_INT_NAME, LANES) lane_int;
#define any_lane(m) any(m)
#define load_lanes(p) JOIN(vload, LANES)(0, (p))
#define store_lanes(v, p) JOIN(vstore, LANES)((v), 0, (p))
#endif
#define count_event(counters, index) atomic_inc((counters) + (index))
#define add_event(counters, index, n) atomic_add((counters) + (index), (n))
typedef uint event_count;
#define sqrt_of(x) sqrt(x)
#define abs_of(x) fabs(x)
#define rint_of(x) rint(x)
#define exp_of(x) exp(x)
#define fma_of(a, b, c) fma((a), (b), (c))

#else  // C++17
#include <cmath>
#include <cstddef>
#ifdef REAL_DOUBLE
typedef double scalar;
typedef long scalar_int;
#else
typedef float scalar;
typedef int scalar_int;
#endif
#define GLOBAL
#define PRIVATE
#define FUNCTION static inline
#if LANES == 1
typedef scalar real;
typedef int mask;
typedef int lane_int;
#define any_lane(m) (m)
#define load_lanes(p) (*(p))
#define store_lanes(v, p) (*(p) = (v))
FUNCTION real sqrt_of(real x) { return std::sqrt(x); }
FUNCTION real abs_of(real x) { return std::fabs(x); }
FUNCTION real rint_of(real x) { return std::rint(x); }
FUNCTION real exp_of(real x) { return std::exp(x); }
FUNCTION real fma_of(real a, real b, real c) { return std::fma(a, b, c); }
#else
typedef scalar real __attribute__((vector_size(LANES * sizeof(scalar))));
typedef scalar_int mask __attribute__((vector_size(LANES * sizeof(scalar))));
typedef mask lane_int;
FUNCTION int any_lane(mask m) {
  scalar_int bits = 0;
  for (int i = 0; i < LANES; ++i) bits |= m[i];
  return bits != 0;
}
FUNCTION real load_lanes(const scalar* p) {
  real r;
  for (int i = 0; i < LANES; ++i) r[i] = p[i];
  return r;
}
FUNCTION void store_lanes(real v, scalar* p) {
  for (int i = 0; i < LANES; ++i) p[i] = v[i];
}
#define EACH_LANE(name)                                            \
  FUNCTION real name##_of(real x) {                                \
    real r;                                                        \
    for (int i = 0; i < LANES; ++i) r[i] = std::name(x[i]);        \
    return r;                                                      \
  }
EACH_LANE(rint)
EACH_LANE(exp)
FUNCTION real abs_of(real x) { return x < 0 ? -x : x; }
FUNCTION real fma_of(real a, real b, real c) {
  real r;
  for (int i = 0; i < LANES; ++i) r[i] = std::fma(a[i], b[i], c[i]);
  return r;
}
#if defined(__AVX__) && LANES == 8 && !defined(REAL_DOUBLE)
FUNCTION real sqrt_of(real x) { return (real)__builtin_ia32_sqrtps256(x); }
#else
EACH_LANE(sqrt)
#endif
#undef EACH_LANE
#endif
typedef unsigned event_count;
FUNCTION void count_event(event_count* counters, int index) { ++counters[index]; }
FUNCTION void add_event(event_count* counters, int index, event_count n) { counters[index] += n; }
#endif

// ---- the same text in both languages from here on ----
#define pick(m, a, b) ((m) ? (a) : (b))
#if defined(__OPENCL_C_VERSION__) || LANES == 1
#define lanes(x) ((real)(scalar)(x))
#define lane_ints(x) ((lane_int)(scalar_int)(x))
#else
#define lanes(x) (real{} + (scalar)(x))
#define lane_ints(x) (lane_int{} + (scalar_int)(x))
#endif

#if LANES == 1
#define not_mask(m) (!(m))
FUNCTION int count_lanes(mask m) { return m != 0; }
FUNCTION int first_lane(mask m, lane_int v) { (void)m; return v; }
FUNCTION scalar sum_lanes(real v) { return v; }
#else
#define not_mask(m) (~(m))
FUNCTION int count_lanes(mask m) {
  int n = 0;
  PRIVATE const scalar_int* p = (PRIVATE const scalar_int*)&m;
  for (int i = 0; i < LANES; ++i) n -= (int)p[i];
  return n;
}
// The value in the first lane where m holds.
FUNCTION int first_lane(mask m, lane_int v) {
  PRIVATE const scalar_int* in = (PRIVATE const scalar_int*)&m;
  PRIVATE const scalar_int* value = (PRIVATE const scalar_int*)&v;
  int found = 0;
  for (int i = LANES - 1; i >= 0; --i)
    if (in[i]) found = (int)value[i];
  return found;
}
FUNCTION scalar sum_lanes(real v) {
  PRIVATE const scalar* p = (PRIVATE const scalar*)&v;
  scalar s = 0;
  for (int i = 0; i < LANES; ++i) s += p[i];
  return s;
}
#endif

// ---- features: baked when SCENE_FEATURES is given, else the scene's own mask ----
enum {
#define FEATURE(name, bit, meaning) FEATURE_##name = 1 << bit,
#include "features.def"
#undef FEATURE
  FEATURES_END
};
#ifdef SCENE_FEATURES
#define has(feature, scene) (((SCENE_FEATURES)&FEATURE_##feature) != 0)
#else
#define has(feature, scene) (((scene)->features & FEATURE_##feature) != 0)
#endif

#endif
