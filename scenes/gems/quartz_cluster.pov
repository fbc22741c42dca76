// A group of quartz crystals from one base of rock: prism m {10-10}, the two rhombohedra r {10-11} and z {01-11}
// of unlike size, and on the tallest ones the trapezohedron x {51-61} that tells right from left quartz. The
// medium is as handed as the shape. Clear and dark backgrounds show through each other; look for: doubled edges
// where a crystal is seen through another, total reflection in the tips, faces r larger than faces z.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 50 }
  max_trace_level 14  adc_bailout 1e-2  exposure 1.4 }

#declare Sky = 0.25;
camera { location <0, 26, -90>  right x  up y  angle 34  look_at <0, 17, 0> }
background { spectrum { d65 scale Sky } }
// a window at the left and one behind
polygon { 5, <0, 0, -20>, <0, 0, 20>, <0, 50, 20>, <0, 50, -20>, <0, 0, -20>  rotate 20*y translate <-60, 10, 10>  luminous { spectrum { d65 } } }
polygon { 5, <-14, 6, 0>, <14, 6, 0>, <14, 44, 0>, <-14, 44, 0>, <-14, 6, 0>  translate <16, 0, 60>  luminous { spectrum { d65 scale 0.8 } } }
polygon { 5, <-60, 0, -30>, <60, 0, -30>, <60, 0, 80>, <-60, 0, 80>, <-60, 0, -30>  translate -0.5*y  luminous { spectrum { d65 scale 0.03 } } }

// Cell: a 4.916, c 5.4054 Angstroem (Levien, Prewitt & Weidner, Am. Mineral. 65, 920 (1980)). The lower half is
// cut off.
#macro Point(Radius, Height, Hand)
  intersection {
    crystal {
      cell { 4.916, 4.916, 5.4054 }  point_group "32"
      form { 1, 0, -1, 0, Radius }
      form { 1, 0, -1, 1, Height*0.62 }
      form { 0, 1, -1, 1, Height*0.66 }
      form { 5, 1, -6, 1, Radius*0.75 + Height*0.182 }
      #if (Hand < 0) left #end
    }
    plane { -y, 0 }
    #if (Hand > 0) interior { M_Quartz_Right } #else interior { M_Quartz_Left } #end
  }
#end
object { Point(6, 34, 1)  rotate 12*y }
object { Point(4.5, 24, -1)  rotate 40*y rotate -9*z translate <11.5, 0, -3> }
object { Point(4, 20, 1)  rotate -20*y rotate 11*z translate <-11.5, 0, -4> }
object { Point(3, 14, 1)  rotate 8*x translate <2, 0, -12> }
object { Point(3.5, 17, -1)  rotate -12*x rotate 50*y translate <-6, 0, 11> }
object { Point(2.4, 9, -1)  rotate <-6, 15, 5> translate <-9, 0, -13> }

// ---- what it must give ----------------------------------------------------------------------------
expect { relative_radiance 550, Sky at <0.05, 0.1> within 1e-6 source "the room beside the crystals" }
