// A contact twin of calcite, as a plate: the optic axis stands at 45 deg on both sides of the twin plane, mirrored
// in it. The extraordinary ray runs aside in the first individual and back in the second: the two images close up
// again where both are of one thickness, and stand apart by the difference where they are not. The wave itself
// does not notice the plane: its index is the same on both sides. Look for: left, equal halves, one image; right,
// one third and two thirds, two images; beside the plates the lines themselves.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { 589.3 }  max_trace_level 40  adc_bailout 1e-8 }

#declare Thickness = 18;      // mm, of both individuals together
#declare View = 20;           // mm
#declare Sky = 0.1;
camera { orthographic  location -60*z  look_at 0  right View*x  up View*y }
background { spectrum { e scale Sky } }
#declare Half = 0.3;          // mm, half the width of a line
#declare Line = polygon { 5, <-Half, -9, 1>, <Half, -9, 1>, <Half, 9, 1>, <-Half, 9, 1>, <-Half, -9, 1> }
#for (I, -3, 3)
  object { Line translate 2.5*I*x  luminous { spectrum { e } } }
#end
#macro Twin(From_X, To_X, Lower)
  box { <From_X, -6, -Lower>, <To_X, 6, 0>  interior { M_Calcite optic_axis <1, 0, -1> }  optical_contact }
  box { <From_X, -6, -Thickness>, <To_X, 6, -Lower>  interior { M_Calcite optic_axis <1, 0, 1> }  optical_contact }
#end
Twin(-9, -0.5, Thickness/2)
Twin(0.5, 9, Thickness*2/3)

// ---- what it must give ----------------------------------------------------------------------------
// The impedance of the extraordinary wave at the plane is the same from both sides: only the outer faces reflect.
#declare N_O = Calcite_O(589.3);
#declare N_E = Calcite_E(589.3);
#declare From_O = (1 - Sky)*Plate_T(N_O)/2;
#declare From_E = (1 - Sky)*Plate_T(Extraordinary_N(N_O, N_E, 45))/2;
#declare Aside = Thickness/3*Tan_Walk_Off(N_O, N_E, 45);
#macro Expect_At(X, O, E, Why)
  expect {
    stokes 589.3, <Sky + O + E, E - O, 0, 0> at <0.5 + (X)/View, 0.5> within 1e-6
    source Why
  }
#end
#declare Hair = 0.005;        // mm
Expect_At(-5 + Half - Hair, From_O, From_E, "equal individuals: one image, edge inside")
Expect_At(-5 + Half + Hair, 0, 0, "equal individuals: one image, edge outside")
Expect_At(-5 - Half + Hair, From_O, From_E, "its other edge, inside")
Expect_At(5, From_O, 0, "ordinary image")
Expect_At(5 - Aside, 0, From_E, "extraordinary image: (d1 - d2) tan(walk-off), Ghosh 1999's indices")
Expect_At(5 - Aside - Half + Hair, 0, From_E, "its edge, inside")
Expect_At(5 - Aside - Half - Hair, 0, 0, "its edge, outside")
