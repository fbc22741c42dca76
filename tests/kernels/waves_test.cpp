// Waves at faces between transparent media of all classes: energy, reciprocity, limits, lanes, single against double
// precision.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "kernels/probe_abi.h"
#include "tests/kernels/wave_media.hpp"

using namespace nicol::test;
using nicol::Vec3;

namespace {

constexpr std::size_t group = 8;  // neighbours of the same classes

// Groups of eight faces of every pair of classes; the faces of a group share their media.
std::vector<WaveCase> faces_of_all_pairs(std::size_t groups_each, double least_birefringence,
    double most_birefringence, double kappa,
                                         unsigned seed) {
  std::vector<WaveCase> faces;
  Dice dice{seed};
  for (int one = 0; one < optics_count; ++one)
    for (int two = 0; two < optics_count; ++two)
      for (std::size_t g = 0; g < groups_each; ++g) {
        const int wave = dice() < 0.5;
        const auto birefringence = [&] { return least_birefringence * std::pow(most_birefringence / least_birefringence, dice()); };
        const std::vector<double> medium1 = random_medium(static_cast<Optics>(one), birefringence(), kappa, dice);
        const std::vector<double> medium2 = random_medium(static_cast<Optics>(two), birefringence(), kappa, dice);
        for (std::size_t i = 0; i < group; ++i) faces.push_back(random_face(medium1, medium2, wave, dice));
      }
  return faces;
}

bool anisotropic_active(const std::vector<double>& medium) {
  return medium[PROBE_MEDIUM_KIND] == 2 && medium[PROBE_MEDIUM_ACTIVE] != 0;
}

double sum(const WaveAnswer& a) { return a.power[0] + a.power[1] + a.power[2] + a.power[3]; }

}  // namespace

TEST_CASE("R + T = 1 as solved, at a million faces between media of all classes") {
  double worst = 0, worst_active = 0, worst_sum = 0;
  std::size_t held = 0, fallbacks = 0;
  for (unsigned round = 0; round < 28; ++round) {
    const std::vector<WaveCase> faces = faces_of_all_pairs(130, 1e-6, 0.3, 1e-4, 77 + round);
    const std::vector<WaveAnswer> answers = double8.waves(faces);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const WaveAnswer& a = answers[i];
      if (i % group == 0) fallbacks += static_cast<std::size_t>(a.fallbacks);
      if (!(a.cos_ray > 1e-3)) continue;
      ++held;
      // p is known to epsilon n^2/p, its flux to epsilon/cos^2: less than 1e-12 farther than 0.01 rad from grazing
      const double grazing = std::max(1.0, std::pow(1e-2 / a.cos_ray, 2));
      const bool active = anisotropic_active(faces[i].one) || anisotropic_active(faces[i].two);
      double& to = active ? worst_active : worst;
      to = std::isnan(a.off) ? 1 : std::max(to, std::fabs(a.off) / grazing);
      worst_sum = std::isnan(sum(a)) ? 1 : std::max(worst_sum, std::fabs(sum(a) - 1));
    }
  }
  MESSAGE(held << " faces: " << worst << ", active crystals " << worst_active << "; waves by the precise way: " << fallbacks);
  CHECK(held > 1000000);
  CHECK(worst < 1e-12);
  // first order in zeta = 1e-4, but for the critical angle and waves of the precise way, which are exact
  CHECK(worst_active < 3e-3);
  CHECK(worst_sum < 1e-14);
}

TEST_CASE("eight lanes give what one lane gives, bit for bit") {
  const std::vector<WaveCase> faces = faces_of_all_pairs(6, 1e-6, 0.6, 1e-3, 5);
  const Kernels* pairs[2][2] = {{&float1, &float8}, {&double1, &double8}};
  for (const auto& pair : pairs) {
    const std::vector<WaveAnswer> one = pair[0]->waves(faces), eight = pair[1]->waves(faces);
    std::size_t different = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (!(one[i].cos_ray > 0)) continue;  // lanes that are not live
      different += one[i].power != eight[i].power || one[i].p != eight[i].p || one[i].gap != eight[i].gap;
    }
    INFO(pair[1]->name);
    CHECK(different == 0);
  }
}

TEST_CASE("the way back through a face is as good as the way there") {
  const Optics optics[] = {Optics::chiral, Optics::uniaxial, Optics::biaxial};
  Dice dice{11};
  double worst = 0;
  std::size_t held = 0;
  for (const Optics first : optics)
    for (const Optics second : optics)
      for (int trial = 0; trial < 300; ++trial) {
        const std::vector<double> one = random_medium(first, 0.1, 5e-3, dice), two = random_medium(second, 0.1, 5e-3,
            dice);
        const WaveCase there = random_face(one, two, trial % 2, dice);
        const WaveAnswer forth = double1.waves({there})[0];
        if (!(forth.cos_ray > 0.05)) continue;
        for (std::size_t j = 2; j < 4; ++j) {
          if (forth.p[j].imag() != 0) continue;
          WaveCase here{two, one, scaled(-1, there.normal), unit(scaled(-1, forth.k[j])), 0};
          const double index = std::sqrt(dot(forth.k[j], forth.k[j]));
          WaveAnswer back[2];
          for (here.wave = 0; here.wave < 2; ++here.wave) back[here.wave] = double1.waves({here})[0];
          const WaveAnswer& b = std::fabs(back[0].index - index) < std::fabs(back[1].index - index) ? back[0] : back[1];
          if (!(b.cos_ray > 0.05)) continue;
          const Vec3 home = scaled(-forth.index, there.s);
          const auto off = [&](std::size_t w) {
            const Vec3 d = plus(b.k[w], scaled(-1, home));
            return dot(d, d);
          };
          worst = std::max(worst, std::fabs(b.power[off(2) < off(3) ? 2 : 3] - forth.power[j]));
          ++held;
        }
      }
  MESSAGE(held << " ways: " << worst);
  CHECK(held > 2000);
  CHECK(worst < 1e-9);
}

TEST_CASE("as birefringence vanishes, a crystal becomes glass") {
  Dice dice{3};
  for (const Kernels* kernels : {&float8, &double8})
    for (const bool biaxial : {false, true})
      for (const bool leaves : {false, true})
        for (int digits = 2; digits <= 8; ++digits) {
          const double d = std::pow(10.0, -digits);
          double worst = 0;
          for (int trial = 0; trial < 40; ++trial) {
            const std::vector<double> air = medium_with({1, 1, 1}, {0, 0, 0}, dice), glass = medium_with({1.6, 1.6,
                1.6}, {0, 0, 0}, dice);
            const std::vector<double> crystal = medium_with({1.6 + d, 1.6 + (biaxial ? 0.3 * d : d), 1.6 - d}, {0, 0,
                0}, dice);
            std::vector<WaveCase> with(group, random_face(leaves ? crystal : air, leaves ? air : crystal, 0, dice));
            const WaveAnswer a = kernels->waves(with)[0];
            if (!(a.cos_ray > 0.05) || (leaves && std::fabs(a.p[2].real() + a.p[2].imag()) < 0.2)) continue;
            // the same polarization in glass: the share of s and p is that of D
            double power[2], share_s = 0;
            const Vec3 u = unit(cross(with[0].normal, with[0].s));
            const Complex along_u = a.incident_d[0] * u.x + a.incident_d[1] * u.y + a.incident_d[2] * u.z;
            share_s = std::norm(along_u);
            const double n1 = leaves ? 1.6 : 1, n2 = leaves ? 1 : 1.6, p1 = n1 * dot(with[0].normal, with[0].s),
                p2s = p1 * p1 + n2 * n2 - n1 * n1;
            const double p2 = p2s > 0 ? std::sqrt(p2s) : 0;
            power[0] = p2 > 0 ? std::pow((p1 - p2) / (p1 + p2), 2) : 1;
            power[1] = p2 > 0 ? std::pow((p1 / (n1 * n1) - p2 / (n2 * n2)) / (p1 / (n1 * n1) + p2 / (n2 * n2)), 2) : 1;
            const double r = share_s * power[0] + (1 - share_s) * power[1];
            worst = std::max(worst, std::fabs(a.power[0] + a.power[1] - r));
          }
          INFO(kernels->name << " birefringence " << d << ": " << worst);
          CHECK(worst < 20 * d + 40 * kernels->epsilon);
        }
}
