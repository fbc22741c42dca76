// Three cubes of 5 mm of one cordierite (iolite), looked through along a, b and c: each before a lamp that is
// polarized to the right (above) and up (below), so that each of the six fields shows what one axis passes. Look
// for: three colours in six fields: blue along b, violet along a, nearly colourless along c; each pair of fields
// of one axis is the same in both its cubes.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 20 }
  max_trace_level 20  adc_bailout 1e-7  exposure 2 }

#declare Thickness = 5;       // mm
#declare View = 22;           // mm
camera { orthographic  location -40*z  look_at 0  right View*x  up View*y }
polygon { 5, <-10.5, 0.1, 5>, <10.5, 0.1, 5>, <10.5, 7, 5>, <-10.5, 7, 5>, <-10.5, 0.1, 5>
  luminous { spectrum { d65 } polarizer { ideal axis x } } }
polygon { 5, <-10.5, -7, 5>, <10.5, -7, 5>, <10.5, -0.1, 5>, <-10.5, -0.1, 5>, <-10.5, -7, 5>
  luminous { spectrum { d65 } polarizer { ideal axis y } } }
#declare Cube = box { -Thickness/2, Thickness/2  interior { M_Cordierite } }
// a cube stands with a to the viewer, b to the right, c up
object { Cube translate -7*x }
object { Cube rotate 90*y }
object { Cube rotate 90*x translate 7*x }

// ---- what it must give ----------------------------------------------------------------------------
// Beer's law along each axis, with Fresnel at both faces, all orders.
#macro Seen(N, Alpha) (Absorbing_Plate_T(N, exp(-(Alpha)*Thickness))) #end
#macro Expect_Axis(Lambda, X, Up, T, Axis)
  expect {
    stokes Lambda, <T/2, (Up ? -1 : 1)*T/2, 0, 0> at <0.5 + X/View, (Up ? 0.55 : 0.45)> within 3e-6
    source concat("Beer's law for light that vibrates along ", Axis, ", Fresnel, all orders")
  }
#end
#for (Lambda, 440, 640, 100)
  #declare T_C = Seen(1.537, M_Band(Lambda, 0.03, 571, 5000) + M_Band(Lambda, 0.15, 350, 5000));
  #declare T_A = Seen(1.542, M_Band(Lambda, 0.35, 555, 5000) + M_Band(Lambda, 0.10, 350, 5000));
  #declare T_B = Seen(1.545, M_Band(Lambda, 0.45, 585, 5000) + M_Band(Lambda, 0.10, 350, 5000));
  Expect_Axis(Lambda, -7, 0, T_B, "b")
  Expect_Axis(Lambda, -7, 1, T_C, "c")
  Expect_Axis(Lambda,  0, 0, T_A, "a")
  Expect_Axis(Lambda,  0, 1, T_C, "c")
  Expect_Axis(Lambda,  7, 0, T_B, "b")
  Expect_Axis(Lambda,  7, 1, T_A, "a")
#end
