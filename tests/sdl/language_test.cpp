// Names, macros, conditionals and loops: the traps of POV-Ray's language, measured with 3.7.
#include "parsed.hpp"

using namespace sdl_test;

TEST_CASE("lexing") {
  CHECK(printed("/* a /* b */ c */ #debug \"x\" // y") == "x");
  CHECK(printed("#  declare A = 2; # debug str(A,1,0)") == "2");
  CHECK(printed("#if(0) don't $ ^ #end #debug \"x\"") == "x");
  CHECK(printed("#debug str(1e,1,0) #debug str(.5e1,1,0)") == "15");
  CHECK(printed("#debug \"a\nb\"") == "a\nb");
  CHECK(said("#if(0) 1.2.3 #end") == "1: Unexpected additional '.' in floating-point number\n");
  CHECK(said("#if(0) \"abc #end").find("No end quote for string.") != std::string::npos);
  CHECK(said("/* abc") == "1: No */ closing comment found.\n");
}

TEST_CASE("declared names: dynamic scope") {
  CHECK(printed("#macro In() #debug str(L,1,0) #end #macro Out() #local L = 3; In() #end Out()") == "3");
  CHECK(printed("#macro In() #declare L = 5; #end #macro Out() #local L = 3; In() #debug str(L,1,0) "
                "#end Out() #ifdef(L) #debug \"global\" #end") == "5");
  CHECK(printed("#macro M() #local X = 1; #end M() #ifndef(X) #debug \"gone\" #end") == "gone");
}

TEST_CASE("redeclaring") {
  CHECK(printed("#declare A = 1; #declare A = \"s\" #debug A") == "s");
  CHECK(printed("#declare A = array[2] {1,2} #declare A = 3; #debug str(A,1,0)") == "3");
  CHECK(said("#declare A = array[2];\n#declare A[0] = 1;\n#declare A[0] = \"s\";") ==
        "3: Attempted to redefine float identifier as string identifier.\n");
  CHECK(said("#macro M(a) a #end #declare M = 3;") ==
        "1: Expected 'undeclared identifier', macro identifier found instead\n");
  CHECK(said("#declare x = 3;") ==
        "1: Expected 'undeclared identifier', vector function 'x' found instead\n");
  Options options;
  options.reserved = {"sphere"};
  CHECK(Parsed("#declare sphere = 3;", options).messages() ==
        "1: Expected 'undeclared identifier', sphere found instead\n");
}

TEST_CASE("semicolons") {
  CHECK(said("#declare A = 3\n\n#declare B = 4;").substr(0, 24) == "3: All #declares of floa");
  CHECK(said("#declare S = \"a\" #declare T = sphere { 0, 1 } #declare R = array[1] {1}") == "");
  CHECK(said("#version 3.1; #declare A = 3 #declare B = 4") == "");
  CHECK(said("#version 3.7; ;") == "1: Expected 'object or directive', ; found instead\n");
}

TEST_CASE("deprecated names are told once where they say so") {
  CHECK(said("#declare deprecated once \"old\" A = 3;\n#declare B = A;\n#declare C = A;") == "2: old\n");
  CHECK(said("#declare deprecated \"old\" A = 3;\n#declare B = A;\n#declare C = A;") == "2: old\n3: old\n");
}

TEST_CASE("version") {
  CHECK(printed("#version unofficial 3.7; #debug str(version,1,2)") == "3.70");
  CHECK(printed("#declare V = version; #version 3.5; #debug str(version,1,1) #version V; "
                "#debug str(version,1,1)") == "3.53.7");
  CHECK(said("#version 3.8;") == "1: Your scene file requires POV-Ray version 3.8 or later!\n");
}

TEST_CASE("arrays") {
  CHECK(printed("#declare A = array[2][2] {{1,2},{3,4}} #debug concat(str(A[1][0],1,0),"
                "str(dimensions(A),1,0),str(dimension_size(A,2),1,0))") == "322");
  CHECK(printed("#declare A = array[2] {1,2} #declare B = A; #declare B[0] = 7; #debug str(A[0],1,0)") == "1");
  CHECK(printed("#declare A = array[2]; #declare A[1] = 1; #ifdef(A[0]) #debug \"0\" #end "
                "#ifdef(A[1]) #debug \"1\" #end") == "1");
  CHECK(said("#declare A = array[2];\n#declare B = A[0];") ==
        "2: Attempt to access uninitialized array element.\n");
  CHECK(said("#declare A = array[2] {1,2,3}") ==
        "1: No matching } in '{', float function 'float constant' found instead\n");
  CHECK(said("#declare A = array[2] {1,2}\n#declare B = A[-1];") == "2: Negative subscript\n");
  CHECK(said("#declare A = array[0];") == "1: Invalid dimension size for an array\n");
}

TEST_CASE("macro arguments: exactly one identifier goes by reference") {
  const std::string m = "#macro M(A,B) #declare A = A+1; #end #declare Q = 1; ";
  CHECK(printed(m + "M(Q,2) #debug str(Q,1,0)") == "2");
  CHECK(printed(m + "M(Q+0,2) #debug str(Q,1,0)") == "1");
  CHECK(printed(m + "M(Q 2) #debug str(Q,1,0)") == "1");  // commas may be left out
  CHECK(printed("#macro M(A) #local A = 9; #end #declare Q = 1; M(Q) #debug str(Q,1,0)") == "9");
  CHECK(printed("#macro M(A) #declare A = 9; #end #declare Q = array[2] {1,2} M(Q[1]) "
                "#debug str(Q[1],1,0)") == "9");
  CHECK(printed("#macro M(A) #declare A[0] = 9; #end #declare Q = array[2] {1,2} M(Q) "
                "#debug str(Q[0],1,0)") == "9");
  CHECK(said("#macro M(A,B) #end\nM(1)") == "2: Expected 2 parameters but only 1 found.\n");
  CHECK(said("#macro M(A,B) #end\nM(1,2,3)") ==
        "2: Expected ')', float function 'float constant' found instead\n");
  CHECK(said("#macro M(A) #end\nM(Foo)") ==
        "2: Cannot pass uninitialized identifier as macro parameter. Initialize identifier first.\n");
}

TEST_CASE("macros yield pieces") {
  CHECK(value("(1+M(2))*2", "#macro M(A) A*A #end") == "10.000000");  // (1+2*2)*2
  CHECK(value("M(3)", "#macro M(N) #if (N > 0) N + M(N-1) #else 0 #end #end") == "6.000000");
  CHECK(tree_of("#macro Open(m) #if (m) merge { #else union { #end #end Open(1) sphere {0,1} }",
                "merge { sphere {0,1} }") == "same");
  CHECK(tree_of("#macro Mods() rotate x*90 scale 2 #end box { 0, 1 Mods() }",
                "box { 0, 1 rotate <90,0,0> scale 2 }") == "same");
  CHECK(printed("#macro A() #macro B() #debug \"b\" #end #end A() B()") == "b");
  CHECK(said("#macro R(N) R(N+1) #end\nR(0)") == "1: Too many nested symbol tables\n");
  CHECK(printed("#macro R(N) #if (N > 0) R(N-1) #else #debug \"end\" #end #end R(90)") == "end");
}

TEST_CASE("conditionals") {
  CHECK(printed("#if (0) #debug \"a\" #elseif (1) #debug \"b\" #else #debug \"c\" #end") == "b");
  CHECK(printed("#switch (1) #case (1) #debug \"1\" #case (2) #debug \"2\" #else #debug \"e\" #end") == "12e");
  CHECK(printed("#switch (2.5) #case (1) #debug \"1\" #break #range (2,3) #debug \"r\" #break "
                "#else #debug \"e\" #end") == "r");
  CHECK(printed("#switch (7) #case (1) #debug \"1\" #break #else #debug \"e\" #end") == "e");
  CHECK(printed("#if (\"a\" = \"a\") #debug \"ok\" #end") == "ok");
  CHECK(said("#else") == "1: Mis-matched '#else'.\n");
  CHECK(said("#end") == "1: Mis-matched '#end'.\n");
  CHECK(said("#case (1)") == "1: Mis-matched '#case' or '#range'.\n");
  CHECK(said("#break") == "1: Invalid context for #break\n");
  CHECK(said("#switch (1) #else #end") == "1: #switch not followed by #case or #range.\n");
  CHECK(said("#if (1)\nsphere { 0, 1 }\n") == "2: End of file reached but #end expected.\n");
  CHECK(said("#macro Unused()\n#if (1)\n#end") == "3: End of file reached but #end expected.\n");
  CHECK(said("#if 1 #end") == "1: Expected '(', float function 'float constant' found instead\n");
}

TEST_CASE("loops") {
  CHECK(printed("#for (i, 0, 1, .25) #end #debug str(i,1,2)") == "1.25");
  CHECK(printed("#declare N = 0; #for (i, 0, 1, .1) #declare N = N+1; #end #debug str(N,1,0)") == "11");
  CHECK(said("#for (i,0,1,0) #end") == "1: #for loop increment must be non-zero.\n");
  CHECK(printed("#for (i, 3, 1, -1) #debug str(i,1,0) #end") == "321");
  CHECK(printed("#declare I = 0; #while (1) #declare I = I+1; #if (I = 3) #break #end #end "
                "#debug str(I,1,0)") == "3");
  CHECK(printed("#declare I = 0; #while (I < 2) #declare J = 0; #while (J < 2) "
                "#debug concat(str(I,1,0),str(J,1,0),\" \") #declare J = J+1; #end "
                "#declare I = I+1; #end") == "00 01 10 11 ");
  CHECK(printed("#for (i,0,2) #switch (i) #case (1) #break #else #debug str(i,1,0) #end #end") == "02");
  CHECK(tree_of("union { #for (i,1,3) sphere { i*x, 1 } #end }",
                "union { sphere { <1,0,0>, 1 } sphere { <2,0,0>, 1 } sphere { <3,0,0>, 1 } }") == "same");
}

TEST_CASE("undef and ifdef") {
  CHECK(printed("#declare A = 1; #undef A #ifndef(A) #debug \"gone\" #end") == "gone");
  CHECK(said("#undef Foo") == "1: Attempt to undef unknown identifier\n");
  CHECK(printed("#ifdef(image_width) #debug str(image_width,1,0) #end") == "640");
}

TEST_CASE("messages") {
  CHECK(said("#warning \"w\"") == "1: w\n");
  CHECK(said("#error \"m\"\nsphere {") == "1: Parse halted by #error directive: m\n");
}

TEST_CASE("options reach the scene") {
  Options options;
  options.declares["Foo"] = 3;
  options.clock = 0.5;
  options.image_width = 320;
  CHECK(Parsed("#debug str(Foo+clock+image_width,1,1)", options).debug == "323.5");
}
