// CDL: examples of its specification, and faults with their places.
#include <doctest/doctest.h>

#include "host/crystallography/cdl.hpp"

namespace nicol::crystallography {

namespace {

Cdl read(const char* text) {
  const auto parsed = parse_cdl(text);
  if (const CdlError* error = std::get_if<CdlError>(&parsed)) {
    FAIL(text, ": ", error->message, " at ", error->at);
    return {};
  }
  return std::get<Cdl>(parsed);
}

struct Bad {
  const char* text;
  std::size_t at;
  const char* message;
};
const Bad bad[] = {
    {"quartz[32]:{10-10}", 0, "unknown crystal system 'quartz'"},
    {"amorphous:{massive}", 0, "an amorphous body has no faces"},
    {"trigonal[33]:{10-10}", 9, "unknown point group '33'"},
    {"trigonal[m3m]:{10-10}", 9, "point group 'm3m' is cubic, not trigonal"},
    {"trigonal[32]{10-10}", 12, "expected ':'"},
    {"trigonal[32]:", 13, "expected a form, as {10-11} or a name"},
    {"trigonal[32]:{1010}", 14,
     "Miller-Bravais indices (h k i l) need h + k + i = 0; here i must be -1"},
    {"trigonal[32]:{0000}", 14, "a face with all indices zero is none"},
    {"trigonal[32]:{10-10", 14, "expected '}'"},
    {"trigonal[32]:{10-1x}", 14, "expected indices, as 10-11 or 1 0 -1 1"},
    {"cubic[m3m]:{10-11}", 12, "four indices belong to hexagonal axes"},
    {"cubic[m3m]:rhombohedron", 11, "no form 'rhombohedron' in the cubic system"},
    {"cubic[m3m]:{111}@", 17, "expected a number"},
    {"cubic[m3m]:{111}@-1", 17, "a distance from the centre is positive"},
    {"cubic[m3m]:{111} + ", 19, "expected a form, as {10-11} or a name"},
    {"cubic[m3m]:{111} ~ cluster[12]", 17, "aggregates and overgrowths of CDL 2 are not read"},
    {"cubic[m3m]:{111}[trigon:dense]", 16, "features of CDL 2 are not read"},
    {"cubic[m3m]:{111} | elongate(c:1.5)", 19,
     "'elongate' is not read: only 'twin(...)' follows '|'; the angles between faces of a crystal "
     "are fixed, distances are not"},
    {"cubic[m3m]:{111} | twin(spnel)", 24, "unknown twin law 'spnel'"},
    {"cubic[m3m]:{111} | twin(spinel", 30, "expected ')'"},
    {"cubic[m3m]:({111} + {100})", 11, "groups of CDL 2 are not read"}};

}  // namespace

TEST_CASE("systems, groups, forms and distances") {
  const Cdl quartz = read("trigonal[32]:{10-10}@1.0 + {10-11}@0.8 + {01-11}@0.9");
  CHECK(quartz.system == System::trigonal);
  CHECK(quartz.point_group == "32");
  REQUIRE(quartz.forms.size() == 3);
  CHECK(quartz.forms[1].face == Miller{1, 0, 1});
  CHECK(quartz.forms[2].face == Miller{0, 1, 1});
  CHECK(quartz.forms[2].distance == 0.9);
  CHECK(read("cubic:{111}").point_group == "m-3m");
  CHECK(read("hexagonal : { 1 0 -1 0 } @ 2 + {0001}").forms[0].distance == 2);
}

TEST_CASE("named forms and labels") {
  const Cdl cube = read("cubic[m3m]:octahedron@1.0 + cube@1.3");
  CHECK(cube.forms[0].face == Miller{1, 1, 1});
  CHECK(cube.forms[1].face == Miller{1, 0, 0});
  CHECK(read("trigonal:rhombohedron_z").forms[0].face == Miller{0, 1, 1});
  CHECK(read("trigonal[32]:body:{10-10} + tip:rhombohedron").forms[1].face == Miller{1, 0, 1});
}

TEST_CASE("twins by name and by axis") {
  const Cdl spinel = read("cubic[m3m]:{111} | twin(spinel)");
  REQUIRE(spinel.twin);
  CHECK(spinel.twin->element == Miller{1, 1, 1});
  const Cdl custom = read("cubic[m3m]:{111} | twin([1,1,1], 60, contact)");
  REQUIRE(custom.twin);
  CHECK(custom.twin->angle_deg == 60);
  CHECK_FALSE(custom.twin->penetration);
  CHECK(read("cubic[m3m]:{210} | twin(iron_cross)").twin->penetration);
}

TEST_CASE("faults are told where they are") {
  for (const Bad& row : bad) {
    CAPTURE(row.text);
    const auto parsed = parse_cdl(row.text);
    const CdlError* error = std::get_if<CdlError>(&parsed);
    REQUIRE(error);
    CHECK(error->message == row.message);
    CHECK(error->at == row.at);
  }
}

}  // namespace nicol::crystallography
