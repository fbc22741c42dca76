// scenes/include/minerals.inc against values of other hands than those that its numbers are from.
#include <fstream>
#include <iterator>
#include <regex>

#include "bound.hpp"
#include "host/optics/crystal.hpp"

namespace nicol {

namespace {

const std::string library = SCENES_FOLDER "/include/minerals.inc";

std::vector<std::string> all_names() {
  std::ifstream file(library);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::regex declared(R"((^|\n)#declare (M_\w+) = interior)");
  std::vector<std::string> names;
  for (std::sregex_iterator it(text.begin(), text.end(), declared), end; it != end; ++it)
    names.push_back((*it)[2]);
  return names;
}

Bound bind_mineral(const std::string& name, const std::string& wavelengths) {
  return bind_text("#include \"minerals.inc\"\nglobal_settings { wavelengths { " + wavelengths + " } }\n" +
                   lit + "box { 0, 1 interior { " + name + " } }");
}

Medium mineral(const std::string& name, const std::string& wavelengths) {
  const Bound b = bind_mineral(name, wavelengths);
  REQUIRE_MESSAGE(!b.parsed->diagnostics.failed(), b.text());
  REQUIRE(b.scene.media.size() == 2);
  return b.scene.media[1];
}

// Values of handbooks for the wavelength at the head; 0 where an index does not exist.
struct Known {
  const char* name;
  double n[3];
  double within;
  const char* source;
};

// HoM: Handbook of Mineralogy; CRC: Handbook of Chemistry and Physics (95th ed.), section 10; HO: Handbook of
// Optics II (1995), ch. 33; K&L: Kaye & Laby (16th ed.), 2.5; DHZ: Deer, Howie & Zussman, midst of ranges.
const Known at_sodium[] = {
    {"M_Quartz_Right", {1.54424, 0, 1.55335}, 5e-5, "K&L, 18 C; -6e-6 per degree"},
    {"M_Calcite", {1.65835, 0, 1.48640}, 3e-4, "K&L; Ghosh's n_e lies 2.7e-4 below it"},
    {"M_Paratellurite_Right", {2.2738, 0, 2.4295}, 2e-3, "Uchida's table, not his formula"},
    {"M_Sapphire", {1.7681, 0, 1.7600}, 5e-4, "HO"},
    {"M_Rutile", {2.616, 0, 2.903}, 1e-2, "K&L"},
    {"M_Dolomite", {1.680, 0, 1.501}, 3e-3, "DHZ"},
    {"M_Nitratine", {1.5874, 0, 1.3361}, 1e-3, "K&L"},
    {"M_Zircon", {1.923, 0, 1.978}, 1e-2, "K&L"},
    {"M_Beryl", {1.576, 0, 1.570}, 5e-3, "K&L"},
    {"M_Elbaite", {1.642, 0, 1.621}, 3e-3, "K&L (tourmaline)"},
    {"M_BBO", {1.670, 0, 1.5534}, 2e-3, "HO"},
    {"M_Lithium_Niobate", {2.300, 0, 2.214}, 1.5e-2, "Bond 1965"},
    {"M_Magnesium_Fluoride", {1.378, 0, 1.390}, 5e-4, "HoM (sellaite)"},
    {"M_KDP", {1.5095, 0, 1.4684}, 1e-3, "K&L"},
    {"M_ADP", {1.5246, 0, 1.4792}, 1e-3, "K&L"},
    {"M_Scheelite", {1.920, 0, 1.936}, 3e-3, "HoM"},
    {"M_Wulfenite", {2.405, 0, 2.283}, 2e-2, "HoM"},
    {"M_Apatite", {1.634, 0, 1.631}, 3e-3, "K&L"},
    {"M_Ice", {1.309, 0, 1.3104}, 6e-4, "HoM"},
    {"M_Aragonite", {1.530, 1.681, 1.6855}, 6e-4, "DHZ"},
    {"M_Topaz", {1.612, 1.615, 1.622}, 2.5e-3, "DHZ"},
    {"M_Chrysoberyl", {1.7395, 1.7415, 1.7485}, 8e-3, "HoM, midst of ranges"},
    {"M_Sulphur", {1.950, 2.038, 2.241}, 8e-3, "K&L"},
    {"M_Cerussite", {1.804, 2.076, 2.078}, 1e-3, "K&L"},
    {"M_Barite", {1.636, 1.637, 1.648}, 1e-3, "DHZ"},
    {"M_Gypsum", {1.520, 1.523, 1.530}, 1e-3, "DHZ"},
    {"M_Diamond", {2.4175, 2.4175, 2.4175}, 1e-3, "K&L"},
    {"M_Spinel", {1.719, 1.719, 1.719}, 5e-3, "HoM"},
    {"M_Fluorite", {1.434, 1.434, 1.434}, 3e-4, "HoM"},
    {"M_Halite", {1.54409, 1.54409, 1.54409}, 1e-4, "Martens 1901: 1.54431 at 18 C, -3.7e-5 per degree"},
    {"M_Sylvite", {1.4904, 1.4904, 1.4904}, 3e-4, "K&L"},
    {"M_Sphalerite", {2.369, 2.369, 2.369}, 3e-3, "HoM"},
    {"M_YAG", {1.8328, 1.8328, 1.8328}, 1e-3, "Bond 1965"},
    {"M_BK7", {1.51673, 1.51673, 1.51673}, 2e-5, "SCHOTT data sheet N-BK7: n_D"},
    {"M_SF11", {1.78446, 1.78446, 1.78446}, 2e-4, "SCHOTT data sheet SF11: n_D"},
    {"M_Fused_Silica", {1.4584, 1.4584, 1.4584}, 1e-4, "K&L"},
    {"M_Water", {1.33336, 1.33336, 1.33336}, 3e-5, "IAPWS 1997, 20 C, against vacuum"},
};

const Known at_green[] = {  // 532 nm
    {"M_KTP", {1.7780, 1.7886, 1.8887}, 2e-3, "data sheets of growers"},
    {"M_LBO", {1.5785, 1.6065, 1.6212}, 1e-3, "data sheets of growers"},
};

const Known at_red[] = {  // 632.8 nm
    {"M_Cinnabar_Right", {2.885, 0, 3.233}, 5e-3, "HO"},
    {"M_Yttrium_Vanadate", {1.9929, 0, 2.2154}, 3e-3, "data sheets of growers"},
    {"M_Potassium_Niobate", {2.1687, 2.2801, 2.3296}, 2e-3, "Zysset et al. 1992, table"},
};

void check_indices(const Known& known, const std::string& lambda_nm) {
  INFO(std::string(known.name), " at ", lambda_nm, " nm, ", std::string(known.source));
  const Medium m = mineral(known.name, lambda_nm);
  for (int i = 0; i < 3; ++i) {
    const double expected = known.n[i] != 0 ? known.n[i] : known.n[0];
    CHECK(std::abs(m.n[i][0] - expected) <= known.within);
  }
}

// The acute angle between the optic axes, and the optical sign.
struct Axes {
  const char* name;
  double two_v_deg, within_deg;
  int sign;
  const char* source;
};

const Axes optic_axes[] = {
    {"M_Aragonite", 18, 1, -1, "DHZ"},        {"M_Topaz", 57, 9, +1, "DHZ: 48 to 68"},
    {"M_Sulphur", 69, 1.5, +1, "HoM"},        {"M_Cerussite", 9, 1, -1, "HoM"},
    {"M_Barite", 37, 3, +1, "HoM"},           {"M_Gypsum", 58, 3, +1, "HoM"},
    {"M_Muscovite", 38, 9, -1, "DHZ"},        {"M_Forsterite", 84, 3, +1, "DHZ: 82 and more"},
    {"M_Andalusite", 80, 7, -1, "DHZ"},       {"M_Sillimanite", 25, 5, +1, "DHZ"},
    {"M_Chrysoberyl", 58, 13, +1, "DHZ: 45 to 71"},
    {"M_Kyanite", 82, 2, -1, "DHZ"},          {"M_Tanzanite", 53, 6, +1, "gemmological tables"},
    {"M_Orthoclase", 55, 20, -1, "DHZ"},      {"M_Albite", 78, 2, +1, "DHZ"},
    {"M_Epidote", 77, 13, -1, "DHZ"},         {"M_KTP", 37.4, 2, +1, "HO: 37.4 at 546 nm"},
    {"M_LBO", 70.8, 3, -1, "109.2 about gamma at 532 nm, data sheets of growers"},
};

}  // namespace

TEST_CASE("minerals: there are many, each says its source and its range") {
  const auto names = all_names();
  CHECK(names.size() >= 50);
  for (const std::string& name : names) {
    INFO(name);
    const Medium m = mineral(name, "589.3");
    CHECK_FALSE(m.source.empty());
    CHECK(m.name != "interior");
    CHECK(m.range_nm[0] > 0);
  }
}

TEST_CASE("minerals: all bind from 380 to 780 nm and within their ranges, there without a word") {
  for (const std::string& name : all_names()) {
    INFO(name);
    const Medium m = mineral(name, "from 380 to 780 step 20");
    const auto wavelength = [](double nm) { return std::to_string(nm) + " "; };
    const double high = std::min(m.range_nm[1], 1000.0);
    const Bound b = bind_mineral(name, wavelength(m.range_nm[0] + 1e-3) + wavelength(high - 1e-3) +
                                           wavelength((m.range_nm[0] + high) / 2));
    // Absorption and rotation are tabulated about the visible; what lies in the ultraviolet may lack them.
    if (m.range_nm[0] >= 350) CHECK_MESSAGE(b.parsed->diagnostics.all().empty(), b.text());
    CHECK_FALSE(b.parsed->diagnostics.failed());
  }
}

TEST_CASE("minerals: indices of handbooks") {
  for (const Known& known : at_sodium) check_indices(known, "589.3");
  for (const Known& known : at_green) check_indices(known, "532");
  for (const Known& known : at_red) check_indices(known, "632.8");
}

TEST_CASE("minerals: angles between optic axes and optical signs of handbooks") {
  for (const Axes& known : optic_axes) {
    INFO(std::string(known.name), ", ", std::string(known.source));
    const Medium m = mineral(known.name, "546.1");
    const double about_gamma = 2 * optic_axis_from_gamma_deg(m.n[0][0], m.n[1][0], m.n[2][0]);
    CHECK((about_gamma < 90 ? 1 : -1) == known.sign);
    CHECK(std::abs(std::min(about_gamma, 180 - about_gamma) - known.two_v_deg) <= known.within_deg);
    CHECK(m.n[0][0] < m.n[1][0]);
    CHECK(m.n[1][0] < m.n[2][0]);
  }
}

TEST_CASE("minerals: rotation along the optic axis") {
  const auto along_axis = [](const std::string& name, double lambda_nm) {
    const Medium m = mineral(name, std::to_string(lambda_nm));
    if (m.symmetry == Medium::Symmetry::isotropic) return m.rotation_deg_per_mm[0];
    return rotation_of_gyration(m.gyration[2][0], m.n[0][0], lambda_nm);
  };
  // Quartz: K&L 21.72 at 589.3, 48.93 at 404.7; CRC 41.55 at 435.8, 25.54 at 546.1, 18.0 at 643.8 (deg/mm, 20 C).
  CHECK(along_axis("M_Quartz_Right", 589.3) == doctest::Approx(21.72).epsilon(1e-3));
  CHECK(along_axis("M_Quartz_Right", 404.7) == doctest::Approx(48.93).epsilon(2e-3));
  CHECK(along_axis("M_Quartz_Right", 435.8) == doctest::Approx(41.55).epsilon(2e-3));
  CHECK(along_axis("M_Quartz_Right", 546.1) == doctest::Approx(25.54).epsilon(2e-3));
  CHECK(along_axis("M_Quartz_Left", 643.8) == doctest::Approx(-18.02).epsilon(3e-3));
  CHECK(along_axis("M_Paratellurite_Right", 632.8) == doctest::Approx(86.9));
  CHECK(along_axis("M_Sodium_Chlorate_Right", 589.3) == doctest::Approx(3.13).epsilon(1e-4));
  CHECK(along_axis("M_Silver_Thiogallate", 589.3) == 0);
  const Medium thiogallate = mineral("M_Silver_Thiogallate", "589.3");
  CHECK(thiogallate.gyration[0][0] == -thiogallate.gyration[1][0]);
}

TEST_CASE("minerals: pleochroism goes the way it looks") {
  const Medium ruby = mineral("M_Ruby", "400 550 650");
  CHECK(ruby.k[0][1] > 1.8 * ruby.k[2][1]);  // green: more for E across c
  CHECK(ruby.k[2][0] > ruby.k[0][0]);        // violet: more along c
  CHECK(ruby.k[0][2] / 650 < 0.1 * ruby.k[0][1] / 550);  // red passes
  const Medium tourmaline = mineral("M_Tourmaline_Green", "550 700");
  CHECK(tourmaline.k[0][1] > 5 * tourmaline.k[2][1]);
  const Medium cordierite = mineral("M_Cordierite", "580");
  CHECK(cordierite.k[2][0] > 5 * cordierite.k[0][0]);
  const Medium sheet = mineral("M_Polaroid", "550");
  CHECK(sheet.k[2][0] > 30 * sheet.k[0][0]);
}

}  // namespace nicol
