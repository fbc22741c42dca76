// Blocks, words and declared things as a tree, and the ways an error leaves the rest readable.
#include "parsed.hpp"

using namespace sdl_test;

TEST_CASE("words keep no meaning, values do") {
  Parsed p("foo { bar 1 \"s\" <1,2,3>, rgb 1 baz { } [0.5 qux] -2*3 on }");
  REQUIRE(p.messages() == "");
  const auto& items = p.result.document.items.at(0).block()->items;
  REQUIRE(items.size() == 9);
  CHECK(*items[0].word() == "bar");
  CHECK(*items[1].number() == 1);
  CHECK(*items[2].string() == "s");
  CHECK(items[3].vector()->size == 3);
  CHECK(items[4].vector()->colour);
  CHECK(items[5].block()->name == "baz");
  CHECK(items[6].block()->name == "[");
  CHECK(*items[6].block()->items.at(1).word() == "qux");
  CHECK(*items[7].number() == -6);
  CHECK(*items[8].number() == 1);
  CHECK(items[5].where.line == 1);
  CHECK(items[5].where.column == 32);
}

TEST_CASE("matrices and long lists") {
  Parsed p("a { matrix <1,0,0, 0,1,0, 0,0,1, 4,5,6> quartic <1,2,3,4,5,6,7> }");
  REQUIRE(p.messages() == "");
  const auto& items = p.result.document.items.at(0).block()->items;
  CHECK(items[1].vector()->size == 12);
  CHECK(items[1].vector()->v[11] == 6);
  CHECK(items[3].block()->name == "<");
  CHECK(items[3].block()->items.size() == 7);
  CHECK(said("a { matrix <1,2,3> }") == "1: Expected '12 numbers', 3 found instead\n");
  CHECK(said("#declare A = <1,2,3,4,5,6>;") == "1: Too many components in vector!\n");
}

TEST_CASE("declared blocks stand as themselves, and are shared") {
  Parsed p("#declare Thing = box { 0, 1 } object { Thing rotate x } Thing");
  REQUIRE(p.messages() == "");
  REQUIRE(p.result.document.items.size() == 2);
  const Block* inside = p.result.document.items[0].block()->items.at(0).block();
  CHECK(inside->name == "box");
  CHECK(inside == p.result.document.items[1].block());
}

TEST_CASE("layers, transforms, defaults") {
  CHECK(tree_of("#declare T = texture { a } texture { b } box { texture { T } }",
                "box { texture { textures { texture { a } texture { b } } } }") == "same");
  CHECK(tree_of("#declare T = texture { a } #if (1) texture { b } #end box { T }",
                "box { textures { texture { a } texture { b } } }") == "same");
  CHECK(tree_of("#declare T = transform { scale 2 } box { transform T transform { T } }",
                "box { transform transform { scale 2 } transform { transform { scale 2 } } }") == "same");
  Parsed p("sphere {0,1} #default { texture { a } } sphere {0,1}");
  REQUIRE(p.result.document.items.size() == 3);
  CHECK(p.result.document.items[1].block()->name == "#default");
  CHECK(p.result.document.items[0].block()->defaults == 0);
  CHECK(p.result.document.items[2].block()->defaults == 1);
}

TEST_CASE("function words without their bracket are words") {
  CHECK(tree_of("a { min 1 max 2 inside }", "a { min 1 max 2 inside }") == "same");
  Parsed p("a { min 1 max(2,3) }");
  CHECK(*p.result.document.items.at(0).block()->items.at(0).word() == "min");
  CHECK(*p.result.document.items.at(0).block()->items.at(2).number() == 3);
}

TEST_CASE("filter belongs to a colour only where a number follows") {
  Parsed p("a { color rgb 1 filter .5, filter all .3 }");
  REQUIRE(p.messages() == "");
  const auto& items = p.result.document.items.at(0).block()->items;
  CHECK(items.at(0).vector()->v[3] == 0.5);
  CHECK(*items.at(1).word() == "filter");
}

TEST_CASE("srgb alone is a word") {
  CHECK(tree_of("a { gamma srgb b srgb 1 }", "a { gamma srgb, b rgb 1 }") == "same");
}

TEST_CASE("top level holds blocks only") {
  CHECK(said("foo") == "1: Expected 'object or directive', undeclared identifier 'foo' found instead\n");
  CHECK(said("3") == "1: Expected 'object or directive', float function 'float constant' found instead\n");
}

TEST_CASE("all errors of a file, and no nonsense after them") {
  CHECK(said("sphere { <0,0,Foo>, 1 pigment { rgb Bar*2 } }\n"
             "box { 0, sin(1,2) }\n"
             "#declare C = Undef + 1;\nsphere { C, 1 }\n"
             "#if (Nope > 3) a { b { } } #else c { ) } #end\n"
             "cylinder { 0, x, Qux*2 }") ==
        "1: Expected 'numeric expression', undeclared identifier 'Foo' found instead\n"
        "1: Expected 'numeric expression', undeclared identifier 'Bar' found instead\n"
        "2: Expected ')', ,  found instead\n"
        "3: Cannot assign uninitialized identifier.\n"
        "5: Expected 'numeric expression', undeclared identifier 'Nope' found instead\n"
        "6: Expected 'numeric expression', undeclared identifier 'Qux' found instead\n");
}

TEST_CASE("an error in a loop is told once, and names after a missing include are not told") {
  CHECK(said("#for (i,0,9) sphere { Foo*2, 1 } #end") ==
        "1: Expected 'numeric expression', undeclared identifier 'Foo' found instead\n");
  CHECK(said("#include \"nosuch.inc\"\nsphere { Foo*2, 1 }\n") ==
        "1: Cannot open include file nosuch.inc.\n");
}

TEST_CASE("what an error spoilt is marked") {
  Parsed p("sphere { 0, Foo*2 } sphere { 0, 1 }");
  REQUIRE(p.result.document.items.size() == 2);
  CHECK(p.result.document.items[0].block()->damaged);
  CHECK(!p.result.document.items[1].block()->damaged);
}

TEST_CASE("the nearest word is named") {
  CHECK(nearest_word("rottate", {"rotate", "scale"}) == "rotate");
  CHECK(nearest_word("xyzzy", {"rotate", "scale"}) == "");
  Parsed p("#declare Radius = 1;\n#declare B = Radus*2;");
  REQUIRE(p.result.diagnostics.error_count() == 1);
  CHECK(p.result.diagnostics.all()[0].message.find("did you mean 'Radius'?") != std::string::npos);
}
