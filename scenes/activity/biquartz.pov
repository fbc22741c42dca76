// Soleil's double plate (1845): right and left quartz side by side, cut across the axis, 3.75 mm thick, between
// parallel polarizers. There the middle of the spectrum turns by 90 deg and goes out, and what is left is the
// sensitive tint, a greyish violet, the same on both sides. In the lower half the analyzer is turned by 4 deg: one
// side turns blue, the other red. That is how saccharimeters were read.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 10 }
  max_trace_level 20  adc_bailout 1e-7  exposure 4 }

#declare Thickness = 3.75;    // mm
#declare Turned = 4;          // deg
#declare View = 20;           // mm
camera { orthographic  location -30*z  look_at 0  right View*x  up View*y }
polygon { 5, <-9.5, -9.5, 1>, <9.5, -9.5, 1>, <9.5, 9.5, 1>, <-9.5, 9.5, 1>, <-9.5, -9.5, 1>
  luminous { spectrum { d65 } polarizer { ideal axis y } } }
#macro Sheet(Y_1, Y_2, Axis)
  polygon { 5, <-9.5, Y_1, -9>, <9.5, Y_1, -9>, <9.5, Y_2, -9>, <-9.5, Y_2, -9>, <-9.5, Y_1, -9>
    polarizer { ideal axis Axis } }
#end
Sheet(0.04, 9.5, y)
Sheet(-9.5, -0.04, <-sin(radians(Turned)), cos(radians(Turned)), 0>)

// Two half discs of 36 sides.
#macro Half_Disc(Hand)
  #local Half = 18;
  prism {
    -Thickness, 0, Half + 2
    #for (I, 0, Half) <(mod(I, Half) = 0 ? 0 : Hand*8*cos(pi*(I/Half - 0.5))), 8*sin(pi*(I/Half - 0.5))>, #end
    <0, -8>
    rotate -90*x
  }
#end
object { Half_Disc(1) translate -Thickness*z interior { M_Quartz_Right optic_axis y } optical_contact }
object { Half_Disc(-1) translate -Thickness*z interior { M_Quartz_Left optic_axis y } optical_contact }

// ---- what it must give ----------------------------------------------------------------------------
// Malus and all orders; the azimuth falls by rho d in right quartz and rises in left quartz.
#macro Expect_At(X, Y, Hand, Analyzer)
  #for (Lambda, 450, 650, 50)
    expect {
      relative_radiance Lambda,
        Plate_T(Quartz_O(Lambda))/2*pow(cos(radians(-Hand*Lowry_Deg_Per_Mm(Lambda)*Thickness - Analyzer)), 2)
      at <0.5 + (X)/View, 0.5 - (Y)/View> within 2e-5
      source "Malus with Lowry's rotation (1935), all orders"
    }
  #end
#end
Expect_At(4, 3, 1, 0)
Expect_At(-4, 3, -1, 0)
Expect_At(4, -3, 1, Turned)
Expect_At(-4, -3, -1, Turned)
