// The kernels' functions in double, whatever scalar and lanes they were compiled with. Cases are taken LANES
// at a time, so that neighbours in a list share a vector.
#pragma once
#include <array>
#include <complex>
#include <string>
#include <vector>

#include "host/pack.hpp"
#include "host/scene.hpp"

namespace nicol::test {

using Complex = std::complex<double>;

struct FresnelCase {
  double p1, delta, eps1;
};
struct FresnelAnswer {
  Complex r_s, r_p;
  double t_s, t_p, p2;
  bool total;
};

// A circular wave (hand +1 left, -1 right; 0: s, 2: p where kappa1 = 0) on a face between active media.
struct ActiveCase {
  double n1, kappa1, n2, kappa2, p1;
  int wave = 1;  // 0 or 1: which of the two waves of medium 1
};
struct ActiveAnswer {
  std::array<double, 4> power;  // reflected 0, 1, transmitted 0, 1: single waves, none made up for
  double r, t;                  // from the sums of the fields
};

struct TurnCase {
  double turns_per_mm, depth_mm;
};
struct StateCase {
  int polarizer;
  Vec3 direction;
};
struct StateAnswer {
  Vec3 axis;
  double amplitude;
};

struct RayCase {
  Vec3 position, direction, axis;  // world mm, for scenes whose camera stands at the origin
};
struct Light {
  double s0, s1, s2, s3, cut_off;  // in the axes (axis, axis x direction)
  bool energy_off;
};
struct Counters {
  unsigned nan = 0, energy = 0, stack = 0, stokes = 0, segments = 0;
};

struct Kernels {
  std::string name;
  int lanes;
  double epsilon;  // rounding of the scalar, 2^-23 or 2^-52
  double (*round)(double);
  std::vector<FresnelAnswer> (*fresnel)(const std::vector<FresnelCase>&);
  std::vector<ActiveAnswer> (*active_face)(const std::vector<ActiveCase>&);
  std::vector<Complex> (*rotation)(const std::vector<TurnCase>&);  // cosine + i sine
  std::vector<StateAnswer> (*passing_states)(const PackedScene&, const std::vector<StateCase>&);
  std::vector<double> (*solve)(const std::vector<double>& problem);  // of probe_abi.h; one lane only, else null
  // One ray per lane; the scene must have the feature lanes_over_pixels when there are several lanes.
  std::vector<Light> (*follow_rays)(const PackedScene&, const std::vector<RayCase>&, int channel, Counters&);
  // The picture, [pixel][channel][S0 S1 S2 S3 cut-off], one sample in the middle of each pixel.
  std::vector<std::array<double, 5>> (*render)(const PackedScene&, Counters&);
};

extern const Kernels float1, float8, double1, double8;
const std::vector<const Kernels*>& all_kernels();

}  // namespace nicol::test
