// How different two colours look: CIE 1976 L*a*b* and CIEDE2000.
#pragma once
#include <array>

namespace nicol {

using Lab = std::array<double, 3>;

// CIE L*a*b* (CIE 15:2018, 8.2.1) of XYZ whose white is D65 with Y = 1. Not clamped: what is brighter than white
// has L* > 100, and what lies outside of all colours (XYZ < 0) follows the straight part of the formula.
Lab lab_of_xyz(const std::array<double, 3>& xyz);

// CIEDE2000 with kL = kC = kH = 1 (Sharma, Wu & Dalal 2005, Color Res. Appl. 30, 21, eqs 2 to 22). About 1 is
// what an eye just tells apart when two patches touch.
double ciede2000(const Lab& first, const Lab& second);

}  // namespace nicol
