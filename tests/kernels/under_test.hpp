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

// The bulk wave `wave` (0, 1) of medium 1 with wave normal s on a face; media as kernels/probe_abi.h has them.
struct WaveCase {
  std::vector<double> one, two;
  Vec3 normal, s;  // normal from 1 to 2; s rounded to the scalar and made unit
  int wave;
};
struct WaveAnswer {
  double index, cos_ray, off;          // of the incident wave; of its ray to the normal; R + T - 1 as solved
  std::array<double, 4> power;         // reflected 0, 1, transmitted 0, 1
  std::array<Complex, 4> amplitude;    // per root of flux
  std::array<Complex, 4> p;
  std::array<Vec3, 4> k;               // real part, world
  std::array<std::array<Complex, 3>, 4> d;  // unit D = -k x h of running waves, world
  std::array<Complex, 3> incident_d;
  std::array<Complex, 3> e_t;          // summed field, world, for incident E of unit length
  std::array<double, 2> gap;           // reflected, transmitted
  int fallbacks;                       // in all lanes of the vector
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
  // Media of eight neighbours from the start are of the same two classes.
  std::vector<WaveAnswer> (*waves)(const std::vector<WaveCase>&);
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
