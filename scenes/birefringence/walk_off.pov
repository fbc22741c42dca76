// A plate of calcite cut at 45 deg to its optic axis, looked through at normal incidence. The ordinary wave runs
// straight on; the ray of the extraordinary one leaves its wave normal by 6.23 deg, so that its image stands
// 1.31 mm aside, away from the optic axis. Look for: two images of half the light each, polarized up and
// to the right (turn the analyzer and one of them goes out); full light where they overlap.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { 589.3 }  max_trace_level 40  adc_bailout 1e-8 }

#declare Thickness = 12;      // mm
#declare Stripe = 2;          // mm, its width
#declare View = 20;           // mm, the picture's edge
#declare Sky = 0.1;           // of the light's radiance
camera { orthographic  location -50*z  look_at 0  right View*x  up View*y }
background { spectrum { e scale Sky } }
#declare Lamp = polygon { 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> }
object { Lamp scale <Stripe/2, 9, 1>  translate z  luminous { spectrum { e } } }
#for (Row, -6, 6)
  disc { <-5, Row*1.4, 1>, -z, 0.35  luminous { spectrum { e } } }
  disc { < 5, Row*1.4, 1>, -z, 0.35  luminous { spectrum { e } } }
#end
box { <-8, -5.5, -Thickness>, <8, 5.5, 0>  interior { M_Calcite optic_axis <1, 0, -1> } }

// ---- what it must give ----------------------------------------------------------------------------
// All orders, and the sky: what a plate does not pass it reflects, so that the light stands out of an even sky.
#declare N_O = Calcite_O(589.3);
#declare N_E = Calcite_E(589.3);
#declare Aside = Thickness*Tan_Walk_Off(N_O, N_E, 45);
#declare From_O = (1 - Sky)*Plate_T(N_O)/2;
#declare From_E = (1 - Sky)*Plate_T(Extraordinary_N(N_O, N_E, 45))/2;
#macro Expect_At(X, O, E, Why)
  expect {
    stokes 589.3, <Sky + O + E, E - O, 0, 0> at <0.5 + X/View, 0.5> within 1e-6
    source Why
  }
#end
#declare Hair = 0.005;        // mm
#declare Edge = Stripe/2;
Expect_At(Edge + Hair, 0, 0, "outside both images")
Expect_At(Edge - Hair, From_O, 0, "ordinary image, its right edge where the stripe's is")
Expect_At(-Aside + Edge + Hair, From_O, 0, "just right of the extraordinary image: d tan(walk-off), Ghosh 1999's indices")
Expect_At(-Aside + Edge - Hair, From_O, From_E, "just inside it")
Expect_At(-Edge + Hair, From_O, From_E, "both images")
Expect_At(-Edge - Hair, 0, From_E, "extraordinary image alone: polarized in the plane of the axis")
Expect_At(-Aside - Edge + Hair, 0, From_E, "its left edge, inside")
Expect_At(-Aside - Edge - Hair, 0, 0, "its left edge, outside")
expect { relative_radiance 589.3, 1 at <0.5, 0.1> within 1e-6 source "the stripe itself" }
