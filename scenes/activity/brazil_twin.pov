// A Brazil twin of quartz: right and left quartz grown together along a slanted plane, axes parallel, looked
// through along the axis between crossed polarizers. Light turns forth in the one and back in the other; what is
// left goes with the difference of the two ways. Look for: a black band where both are equally thick, and colours
// that answer each other on both sides of it, as in the edges of amethyst. In the lower half, a plate of right
// quartz as thick as the twin lies in the way as well, and the black band moves to where it undoes the twin.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 25 }
  max_trace_level 20  adc_bailout 1e-4  exposure 2 }

#declare Thickness = 10;      // mm
#declare View = 20;           // mm
camera { orthographic  location -40*z  look_at 0  right View*x  up View*y }
polygon { 5, <-9.5, -9.5, 2>, <9.5, -9.5, 2>, <9.5, 9.5, 2>, <-9.5, 9.5, 2>, <-9.5, -9.5, 2>
  luminous { spectrum { d65 } polarizer { ideal axis y } } }
polygon { 5, <-9.5, -9.5, -25>, <9.5, -9.5, -25>, <9.5, 9.5, -25>, <-9.5, 9.5, -25>, <-9.5, -9.5, -25>
  polarizer { ideal axis x } }
prism { -8, 8, 4, <-8, -Thickness>, <8, 0>, <-8, 0>, <-8, -Thickness>
  interior { M_Quartz_Left optic_axis z }  optical_contact }
prism { -8, 8, 4, <-8, -Thickness>, <8, -Thickness>, <8, 0>, <-8, -Thickness>
  interior { M_Quartz_Right optic_axis z }  optical_contact }
box { <-8, -8, -21>, <8, 0, -21 + Thickness>  interior { M_Quartz_Right optic_axis z } }

// ---- what it must give ----------------------------------------------------------------------------
// At x the left crystal is (8 - x)/16 of the thickness. Its plane reflects nothing to speak of (kappa/n = 2e-5),
// so that the orders are those of the two outer faces; below, of four, where every order turns as the first: 1/T =
// 1 + sum R/(1 - R).
#macro Expect_At(X, Below)
  #for (Lambda, 450, 650, 50)
    #local R = Normal_R(1, Quartz_O(Lambda));
    #local T = 1/(1 + (Below ? 4 : 2)*R/(1 - R));
    expect {
      relative_radiance Lambda, T/2*pow(sin(radians(Lowry_Deg_Per_Mm(Lambda)*Thickness*(X/8 + Below))), 2)
      at <0.5 + X/View, 0.5 + (Below ? 4 : -4)/View> within 4e-4
      source "Malus with Lowry's rotation (1935) times the difference of the ways, all orders"
    }
  #end
#end
Expect_At(0, 0)
Expect_At(3, 0)
Expect_At(-3, 0)
Expect_At(6, 0)
Expect_At(-6, 1)
Expect_At(2, 1)
