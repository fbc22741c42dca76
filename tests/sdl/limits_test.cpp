// Hostile text ends in an error: never in a crash, a hang or a full memory.
#include "parsed.hpp"

using namespace sdl_test;

namespace {

std::string repeated(const std::string& part, int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += part;
  return out;
}

// Small limits, so that the test takes no time; the last message is what ended the parse.
std::string end_of(const std::string& text) {
  Options options;
  options.limits.steps = 300'000;
  options.limits.items = 100'000;
  Parsed parsed(text, options);
  REQUIRE(parsed.result.diagnostics.failed());
  return parsed.result.diagnostics.all().back().message;
}

const std::string steps = "The scene takes too many steps: does a loop never end?";
const std::string braces = "Too many nested '{' braces.";

}  // namespace

TEST_CASE("loops and macros without end") {
  CHECK(end_of("#while (1) #end") == steps);
  CHECK(end_of("#for (i, 0, 1e9) #end") == steps);
  CHECK(end_of("#macro A(N) #if (N > 0) A(N-1) A(N-1) A(N-1) #end #end A(60)") == steps);
  CHECK(end_of("#macro A() A() #end A()") == "Too many nested symbol tables");
  std::string functions = "#declare F0 = function(a) { a }\n";
  for (int i = 1; i < 60; ++i) {
    const std::string before = "F" + std::to_string(i - 1) + "(a)";
    functions += "#declare F" + std::to_string(i) + " = function(a) { " + before + "+" + before + " }\n";
  }
  CHECK(end_of(functions + "#declare A = F59(1);") == steps);
}

TEST_CASE("an error in a loop without end is told once, and ends it") {
  Parsed parsed("#for (I, 0, 1, 1e-300) linear_spln(I, 2e-6) #end\n#declare = 1;");
  REQUIRE(parsed.result.diagnostics.all().size() == 1);
  CHECK(parsed.result.diagnostics.all()[0].message == "Expected 'object or directive', undeclared identifier 'linear_spln' found instead");
}

TEST_CASE("deep nesting") {
  CHECK(end_of(repeated("a { ", 100000)) == braces);
  CHECK(end_of("a { " + repeated("[", 100000)) == braces);
  CHECK(end_of("#declare A = " + repeated("(", 100000)) == braces);
  CHECK(end_of("#declare A = " + repeated("<", 100000)) == braces);
  CHECK(end_of("#declare F = function { " + repeated("(", 100000)) == braces);
  CHECK(end_of("#declare A = " + repeated("sin(", 100000)) == braces);
  CHECK(end_of("#declare A = " + repeated("array[1] {", 100000)) != "");
  CHECK(end_of("#macro M(a) #end " + repeated("M(", 100000)) == braces);
  CHECK(end_of("#declare A = b { } #while (1) #declare A = b { A } #end") == braces);
  CHECK(end_of("#declare A = (" + repeated("1?1:", 100000)) == braces);
  CHECK(said("#declare A = " + repeated("-", 100001) + "1;\n#debug str(A,1,0)") == "");
}

TEST_CASE("memory") {
  CHECK(end_of("#declare A = array[1e9];") == "Too large an array.");
  CHECK(end_of("#declare A = array[1e5][1e5][1e5][1e5][1e5];") == "Too large an array.");
  CHECK(end_of("#declare S = \"abcdefgh\" #while (1) #declare S = concat(S,S) #end") == "Out of memory.");
  CHECK(end_of("#declare A = a { 1 } #while (1) #declare A = b { A A } #end") == "Too many objects.");
  CHECK(end_of("#while (1) a { b b b b b b b b b b b b b } #end") == "Out of memory.");
  CHECK(end_of("#declare N = 0; #macro M(N) #local A = array[40000] M(0) #end M(1)") == "Out of memory.");
}

TEST_CASE("odd bytes and odd files") {
  CHECK(end_of(std::string("a { \0 }", 7)) == "Illegal character in input file, value is 00.");
  CHECK(end_of("a { \xc3\xa9 }") == "Illegal character in input file, value is c3.");
  CHECK(said("#debug \"\xff\xfe\" // \xc3") == "");
  CHECK(said("\xEF\xBB\xBFsphere { 0, 1 }") == "");
  CHECK(end_of("#include \"/\"").find("Cannot open include file /.") == 0);
  CHECK(end_of("#include \"/dev/zero\"").find("Cannot open include file /dev/zero.") == 0);
  Result folder;
  parse_file("/", {}, folder);
  CHECK(folder.diagnostics.text().find("Cannot open input file.") != std::string::npos);
}

TEST_CASE("a hundred errors are enough") {
  Parsed parsed(repeated("a { Foo*2 }\n", 1000));
  CHECK(parsed.result.diagnostics.error_count() == 100);
}
