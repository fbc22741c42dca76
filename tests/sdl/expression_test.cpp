// Numbers, vectors and their built-ins as POV-Ray 3.7 computes them; values measured with it.
#include "parsed.hpp"

using namespace sdl_test;

TEST_CASE("precedence and signs") {
  CHECK(value("1+2*3") == "7.000000");
  CHECK(value("-2*3") == "-6.000000");
  CHECK(value("- -2") == "2.000000");
  CHECK(value("!1+2") == "2.000000");
  CHECK(value("8/4/2") == "1.000000");
  CHECK(value("-<1,2,3>.y") == "-2.000000");
  CHECK(value("(1|0&0)") == "0.000000");  // one level, left to right
  CHECK(value("(1<2<3)") == "1.000000");
  CHECK(value("(3>2>1)") == "0.000000");
  CHECK(value("(1 | 0 ? 5 : 6)") == "5.000000");
  CHECK(value("(0 ? 5 : 0 ? 6 : 7)") == "7.000000");
}

TEST_CASE("comparisons have a tolerance, but not < and >") {
  CHECK(value("(1 = 1+1e-11)") == "1.000000");
  CHECK(value("(1 != 1+1e-11)") == "0.000000");
  CHECK(value("(1+1e-11 <= 1)") == "1.000000");
  CHECK(value("(1 < 1+1e-11)") == "1.000000");
  CHECK(value("(\"abc\" < \"abd\")") == "1.000000");
  CHECK(value("(\"a\" = \"a\" & 1)") == "1.000000");
}

TEST_CASE("comparisons only inside parentheses") {
  CHECK(said("#declare B = 1 < 2;").find("require semi-colon") != std::string::npos);
  CHECK(said("#declare B = (<1,2,3> < 2);") ==
        "1: Float expected but vector or color expression found.\n");
}

TEST_CASE("directives inside expressions") {
  CHECK(value("1+#if(1)10 #else 20 #end") == "11.000000");
  CHECK(value("(1+#if(0)10 #else 20 #end)") == "21.000000");
  CHECK(value("(1 #declare Q = 5; +Q)", "#declare Q = 1;") == "6.000000");
}

TEST_CASE("promotion") {
  CHECK(vector("<1,2>+<10,20,30>") == "11.0000,22.0000,30.0000");
  CHECK(vector("<1,2,3>*<4,5,6>") == "4.0000,10.0000,18.0000");
  CHECK(vector("<1,2,3>+1") == "2.0000,3.0000,4.0000");
  CHECK(vector("<1 -1 0>", "", 2) == "0.0000,0.0000");  // 1-1 is one component
  CHECK(vector("!<1,0,2>") == "0.0000,1.0000,0.0000");
  CHECK(vector("2*x+3*y") == "2.0000,3.0000,0.0000");
  CHECK(vector("t", "", 4) == "0.0000,0.0000,0.0000,1.0000");
  CHECK(vector("v", "", 2) == "0.0000,1.0000");
  CHECK(vector("(1?<1,2,3>:<4,5,6>)") == "1.0000,2.0000,3.0000");
  CHECK(said("#declare A = <1,x,2>;") == "1: Float expected but vector or color expression found.\n");
}

TEST_CASE("dot access") {
  const std::string v = "#declare V = <1,2,3>;";
  CHECK(value("V.z", v) == "3.000000");
  CHECK(value("(V+V).x", v) == "2.000000");
  CHECK(value("V.green", v) == "2.000000");
  CHECK(value("vcross(x,y).z") == "1.000000");
  CHECK(said("#declare V=<1,2,3>;\n#declare A = V.t;") == "2: Bad operands for period operator.\n");
  CHECK(printed("#declare C=rgb<.2,.4,.6>; #debug str(C.gray,1,8)") == "0.36340000");
}

TEST_CASE("colours are five numbers") {
  CHECK(vector("rgb .5", "", 5) == "0.5000,0.5000,0.5000,0.0000,0.0000");
  CHECK(vector("rgbf 1", "", 5) == "1.0000,1.0000,1.0000,1.0000,0.0000");
  CHECK(vector("rgbt <1,2,3,.4>", "", 5) == "1.0000,2.0000,3.0000,0.0000,0.4000");
  CHECK(vector("rgbft .5", "", 5) == "0.5000,0.5000,0.5000,0.5000,0.5000");
  CHECK(vector("rgb <1,2>", "", 5) == "1.0000,2.0000,0.0000,0.0000,0.0000");
  CHECK(vector("color .5", "", 5) == "0.5000,0.5000,0.5000,0.5000,0.5000");
  CHECK(vector("color <.5,.6,.7>", "", 5) == "0.5000,0.6000,0.7000,0.0000,0.0000");
  CHECK(vector("color red 1 green .5", "", 5) == "1.0000,0.5000,0.0000,0.0000,0.0000");
  CHECK(vector("rgb 1 + 1", "", 5) == "2.0000,2.0000,2.0000,0.0000,0.0000");
  const std::string white = "#declare White = rgb 1;";
  CHECK(vector("color White filter .9", white, 5) == "1.0000,1.0000,1.0000,0.9000,0.0000");
  CHECK(vector("White*.5", white, 5) == "0.5000,0.5000,0.5000,0.0000,0.0000");
  CHECK(vector("color White*.5 transmit .3", white, 5) == "0.5000,0.5000,0.5000,0.0000,0.3000");
  CHECK(vector("White+1", white, 5) == "2.0000,2.0000,2.0000,1.0000,1.0000");
  CHECK(vector("srgb <.2,.5,1>", "", 5) == "0.0331,0.2140,1.0000,0.0000,0.0000");
}

TEST_CASE("float built-ins") {
  CHECK(value("int(-1.5)") == "-1.000000");
  CHECK(value("mod(-7,3)") == "-1.000000");
  CHECK(value("div(-7,3)") == "-2.000000");
  CHECK(value("max(1,2,5)+min(3,2,7)") == "7.000000");
  CHECK(value("select(-1,1,2)*100+select(0,1,2)*10+select(0,1,2,3)") == "122.000000");
  CHECK(value("degrees(pi)+radians(180)") == "183.141593");
  CHECK(value("bitwise_and(6,3)+bitwise_or(6,3)*10+bitwise_xor(6,3)*100") == "572.000000");
  CHECK(value("acos(2)") == "0.000000");
  CHECK(value("1/0") == "inf");
  CHECK(said("#declare A = 1/0;") == "1: Divide by zero.\n");
  CHECK(said("#declare A = sqrt(-1);") == "1: sqrt of negative number -1.000000\n");
  CHECK(said("#declare A = ln(0);") == "1: ln of negative number 0.000000\n");
  CHECK(said("#declare A = pow(0,0);") == "1: Domain error.\n");
  CHECK(said("#declare A = atan2(0,0);") == "1: Domain error in 'atan2'!\n");
  CHECK(said("#declare A = sin(1,2);") == "1: Expected ')', ,  found instead\n");
  CHECK(said("#declare A = sin 1;") == "1: Expected '(', float function 'float constant' found instead\n");
}

TEST_CASE("vector built-ins follow the right hand") {
  CHECK(vector("vrotate(x,90*y)") == "0.0000,0.0000,-1.0000");
  CHECK(vector("vrotate(x,90*z)") == "0.0000,1.0000,0.0000");
  CHECK(vector("vcross(x,y)") == "0.0000,0.0000,1.0000");
  CHECK(vector("vaxis_rotate(x,<1,1,1>,120)+1") == "1.0000,2.0000,1.0000");
  CHECK(vector("vnormalize(<3,0,4>)") == "0.6000,0.0000,0.8000");
  CHECK(value("vlength(5)") == "8.660254");
  CHECK(value("vdot(<1,2>,3)") == "9.000000");
}

TEST_CASE("random numbers are POV-Ray's, digit by digit") {
  CHECK(printed("#declare R = seed(1); #debug concat(str(rand(R),1,12),\" \",str(rand(R),1,12),\" \","
                "str(rand(R),1,12))") == "0.421992875268 0.487121198207 0.665896215631");
  CHECK(said("#declare A = rand(0);") == "1: Illegal random number generator.\n");
}

TEST_CASE("strings") {
  CHECK(printed("#debug concat(\"a\" \"b\", \"c\")") == "abc");
  CHECK(printed("#debug concat(\"[\",str(1.5,8,2),\"|\",str(1.5,-8,2),\"|\",str(2/3,0,-1),\"]\")") ==
        "[    1.50|00001.50|0.666667]");
  CHECK(printed("#debug concat(substr(\"hello\",2,3),chr(65),strlwr(\"AbC\"),strupr(\"aBc\"))") ==
        "ellAabcABC");
  CHECK(value("strlen(\"hello\")+asc(\"A\")*10+val(\"12.5x\")") == "667.500000");
  CHECK(printed("#debug vstr(2,<1,2,3>,\"-\",5,2)") == " 1.00- 2.00");
  CHECK(printed("#debug \"a\\tb\\\"c\\u00e9\"") == "a\tb\"c\xc3\xa9");
  CHECK(said("#debug \"a\\qb\"") == "1: Illegal escape sequence in string.\n");
  CHECK(said("#debug substr(\"hello\",5,2)") == "1: Illegal parameters in substr.\n");
  CHECK(said("#debug str(1,1e9,0)") ==
        "1: Invalid formatting code in format string, or resulting string too long.\n");
}

TEST_CASE("functions capture floats where they are declared") {
  CHECK(value("F(3)", "#declare K = 2; #declare F = function(a) { a*K + 1 } #declare K = 9;") == "7.000000");
  CHECK(value("F(1,2,3)", "#declare F = function { x+y*z }") == "7.000000");
  CHECK(value("F(2)", "#declare F = function(a) { a>1 & a<3 }") == "1.000000");
  CHECK(value("G(2,3)", "#declare F=function(a){-a*2} #declare G=function(a,b){F(a)+F(b)}") == "-10.000000");
  CHECK(vector("F(1,2,3)", "#declare F = function { transform { translate x rotate 90*z } }") ==
        "-2.0000,2.0000,3.0000");
  CHECK(vector("F(-2,2,3)", "#declare F = function { transform { translate x rotate 90*z inverse } }") ==
        "1.0000,2.0000,3.0000");
  CHECK(said("#declare V=<1,2,3>;\n#declare F=function(a){a*V}") ==
        "2: Expected 'operand', vector function 'vector identifier' found instead\n");
  CHECK(said("#declare F=function { internal(3) }\n#declare A = F(1,2,3);") ==
        "2: internal(3) is not supported in a function.\n");
  CHECK(said("#declare F=function { pattern { bozo } }") == "");
  CHECK(said("#declare F=function(x){x} #declare F=3;") ==
        "1: Redeclaring functions is not allowed - #undef the function first!\n");
}

TEST_CASE("splines as measured with POV-Ray") {
  const std::string knots = " 1,<1,2,3>, 2,<0,5,1>, 3,<2,2,2> }";
  CHECK(vector("S(.5)", "#declare S = spline { linear_spline 0,<0,0,0> 1,<1,2,3> }") ==
        "0.5000,1.0000,1.5000");
  CHECK(vector("S(.5)", "#declare S = spline { natural_spline 0,<0,0,0>," + knots) ==
        "0.7750,0.7500,2.0750");
  CHECK(vector("S(1.5)*10", "#declare S = spline { cubic_spline -1,<0,0,0>," + knots) ==
        "4.0625,37.5000,20.3125");
  CHECK(vector("S(1.5)", "#declare S = spline { quadratic_spline -1,<0,0,0>," + knots) ==
        "0.6250,3.3333,2.2917");
}

TEST_CASE("what needs geometry is refused by name") {
  CHECK(said("#declare S = sphere { 0, 1 }\n#declare V = trace(S, 0, z);") ==
        "2: 'trace' is not supported.\n");
  CHECK(said("#macro Unused() #fopen F \"x\" write trace(1) #end") == "");
  CHECK(said("#fopen F \"x\" write") == "1: #fopen is not supported.\n");
}
