// The only file that knows the difference between OpenCL C 1.2 and C++17, and between one lane and many.
// Set by the build: LANES (1, 4, 8, 16), REAL_DOUBLE (defined: fp64), SCENE_FEATURES (mask; undefined: generic),
// NICOL_FP64 (defined: the device has fp64).
//   scalar  float or double          real      LANES scalars, one per lane
//   precise double where there is one, else scalar: for the few lanes that need it, one by one
//   mask    result of comparing reals lane_int  an integer per lane, as wide as scalar
// pick(m, a, b) takes a where m holds, b elsewhere, lane by lane.
#ifndef NICOL_PORTABLE_H
#define NICOL_PORTABLE_H

#ifndef LANES
#define LANES 1
#endif

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)

#ifdef REAL_DOUBLE
#define SCALAR_NAME double
#define SCALAR_INT_NAME long
#else
#define SCALAR_NAME float
#define SCALAR_INT_NAME int
#endif
typedef SCALAR_NAME scalar;
typedef SCALAR_INT_NAME scalar_int;
#if !defined(__OPENCL_C_VERSION__) || defined(REAL_DOUBLE) || defined(NICOL_FP64)
#ifdef __OPENCL_C_VERSION__
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#endif
typedef double precise;
#define PRECISE_IS_DOUBLE 1
#else
typedef scalar precise;
#define PRECISE_IS_DOUBLE 0
#endif
#if LANES == 1
typedef scalar real;
typedef int mask;
typedef int lane_int;
typedef int lane_int_scalar;
#define any_lane(m) (m)
#define load_lanes(p) (*(p))
#define store_lanes(v, p) (*(p) = (v))
#endif

#if LANES > 1
typedef scalar_int lane_int_scalar;
#endif

#ifdef __OPENCL_C_VERSION__
#define GLOBAL __global
#define PRIVATE __private
#define FUNCTION static inline
#if LANES > 1
typedef JOIN(SCALAR_NAME, LANES) real;
typedef JOIN(SCALAR_INT_NAME, LANES) mask;
typedef JOIN(SCALAR_INT_NAME, LANES) lane_int;
#define load_lanes(p) JOIN(vload, LANES)(0, (p))
#define store_lanes(v, p) JOIN(vstore, LANES)((v), 0, (p))
#endif
#define count_event(counters, index) atomic_inc((counters) + (index))
#define add_event(counters, index, n) atomic_add((counters) + (index), (n))
typedef uint event_count;
#define sqrt_of(x) sqrt(x)
#define precise_sqrt(x) sqrt(x)
#define precise_abs(x) fabs(x)
#define abs_of(x) fabs(x)
#define rint_of(x) rint(x)
#define exp_of(x) exp(x)
#define cos_of(x) cos(x)
#define sin_of(x) sin(x)
#define fma_of(a, b, c) fma((a), (b), (c))

#else  // C++17
#include <cmath>
#include <cstddef>
#define GLOBAL
#define PRIVATE
#define FUNCTION static inline
FUNCTION precise precise_sqrt(precise x) { return std::sqrt(x); }
FUNCTION precise precise_abs(precise x) { return std::fabs(x); }
#if LANES == 1
FUNCTION real sqrt_of(real x) { return std::sqrt(x); }
FUNCTION real abs_of(real x) { return std::fabs(x); }
FUNCTION real rint_of(real x) { return std::rint(x); }
FUNCTION real exp_of(real x) { return std::exp(x); }
FUNCTION real cos_of(real x) { return std::cos(x); }
FUNCTION real sin_of(real x) { return std::sin(x); }
FUNCTION real fma_of(real a, real b, real c) { return std::fma(a, b, c); }
#else
typedef scalar real __attribute__((vector_size(LANES * sizeof(scalar))));
typedef scalar_int mask __attribute__((vector_size(LANES * sizeof(scalar))));
typedef mask lane_int;
FUNCTION int any_lane(mask m) {
#if defined(__AVX__) && LANES == 8 && !defined(REAL_DOUBLE)
  typedef float bits __attribute__((vector_size(32)));
  return __builtin_ia32_movmskps256((bits)m) != 0;
#else
  scalar_int found = 0;
  for (int i = 0; i < LANES; ++i) found |= m[i];
  return found != 0;
#endif
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
EACH_LANE(cos)
EACH_LANE(sin)
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
FUNCTION int largest_lane(lane_int v) { return v; }
FUNCTION scalar sum_lanes(real v) { return v; }
#else
#define not_mask(m) (~(m))
#ifdef __OPENCL_C_VERSION__
// Halving by hand: PoCL's any() and loops over lanes go through memory lane by lane.
#define fold_2(v, op) ((v).x op (v).y)
#define fold_4(v, op) fold_2((v).lo op (v).hi, op)
#define fold_8(v, op) fold_4((v).lo op (v).hi, op)
#define fold_16(v, op) fold_8((v).lo op (v).hi, op)
#define fold_lanes(v, op) JOIN(fold_, LANES)(v, op)
FUNCTION int any_lane(mask m) { return fold_lanes(m, |) != 0; }
FUNCTION int count_lanes(mask m) { return -(int)fold_lanes(m, +); }
FUNCTION scalar sum_lanes(real v) { return fold_lanes(v, +); }
#define largest_2(v) max((v).x, (v).y)
#define largest_4(v) largest_2(max((v).lo, (v).hi))
#define largest_8(v) largest_4(max((v).lo, (v).hi))
#define largest_16(v) largest_8(max((v).lo, (v).hi))
FUNCTION int largest_lane(lane_int v) { return (int)JOIN(largest_, LANES)(v); }
#else
FUNCTION int count_lanes(mask m) {
  scalar_int n = 0;
  for (int i = 0; i < LANES; ++i) n -= m[i];
  return (int)n;
}
FUNCTION scalar sum_lanes(real v) {
  scalar s = 0;
  for (int i = 0; i < LANES; ++i) s += v[i];
  return s;
}
FUNCTION int largest_lane(lane_int v) {
  scalar_int largest = v[0];
  for (int i = 1; i < LANES; ++i) largest = v[i] > largest ? v[i] : largest;
  return (int)largest;
}
#endif
#endif

// Marks what a path meets. Nothing, unless whoever writes paths down (host/record) has set it before: then `call` is made.
#ifndef WITNESS
#define WITNESS(call)
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
