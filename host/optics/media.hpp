// Media by formula: refractive index, optical rotation and absorption as functions of wavelength.
// Wavelengths go in as nm; the micrometres of the published formulas stay inside this folder.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace nicol {

// Refractive index n(lambda). Coefficients as published, wavelengths in um.
struct IndexFormula {
  enum class Kind {
    constant,    // {n}
    cauchy,      // {A, B, C, ...}: n = A + B/l^2 + C/l^4 + ...
    sellmeier,   // {B1, C1, B2, C2, ...}: n^2 = 1 + sum B l^2/(l^2 - C), C in um^2
    numbered,    // refractiveindex.info's formula 1..9 with its coefficients in its order
    table,       // points
    povray,      // {ior, dispersion}: n = ior * dispersion^(-(lambda - 555 nm)/350 nm)
    mean         // arithmetic mean of `parts`
  };
  Kind kind = Kind::constant;
  int number = 0;                                   // numbered: 1..9
  std::vector<double> coefficients;
  std::vector<std::pair<double, double>> points;    // table: nm, n; ascending
  std::vector<IndexFormula> parts;                  // mean
};

// Rotation of the plane of polarization, deg/mm, > 0 dextro. Wavelengths in um.
struct RotationFormula {
  enum class Kind {
    none,
    constant,        // {deg_per_mm}
    biot,            // {A}: A/l^2 (deg/mm um^2); further terms {A, B}: A/l^2 + B/l^4
    drude,           // {A1, L1, A2, L2, ...}: sum A/(l^2 - L), L = lambda_i^2 in um^2; a last lone number is a constant
    chandrasekhar,   // {k, lambda0_um}: k l^2/(l^2 - lambda0^2)^2
    table            // points: nm, deg/mm
  };
  Kind kind = Kind::none;
  std::vector<double> coefficients;
  std::vector<std::pair<double, double>> points;
  double scale = 1;   // 75 for the founding paper's strong crystal, -1 for the left-handed one
};

// Absorption of intensity per mm (Beer: exp(-absorb_per_mm * path_mm)).
struct AbsorptionFormula {
  enum class Kind { none, constant, table };
  Kind kind = Kind::none;
  double per_mm = 0;
  std::vector<std::pair<double, double>> points;    // nm, 1/mm
};

// Values at lambda_nm. Tables interpolate by a monotone cubic (Fritsch & Carlson 1980) and answer NaN
// outside their points; formulas answer NaN where they have no real positive value.
double refractive_index(const IndexFormula& formula, double lambda_nm);
double rotation_deg_per_mm(const RotationFormula& formula, double lambda_nm);
double absorb_per_mm(const AbsorptionFormula& formula, double lambda_nm);

// "" if the coefficients fit the formula, else what is wrong ("formula 2 takes 1 + 2m coefficients, 4 given").
std::string check(const IndexFormula& formula);
std::string check(const RotationFormula& formula);
std::string check(const AbsorptionFormula& formula);

// Calcite at room temperature (Ghosh 1999, Opt. Commun. 163, 95): ordinary and extraordinary index.
IndexFormula calcite_ordinary();
IndexFormula calcite_extraordinary();

}  // namespace nicol
