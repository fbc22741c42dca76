// Airy's spirals (1831): right and left quartz, 4 mm each, cut across the axis, one on the other between crossed
// polarizers, seen under all angles up to 17 deg in sodium light. One plate alone would show rings about a bright
// middle; the two of opposite hand undo each other's rotation along the axis, and off it the black cross winds up
// into four spirals. Exchange the plates, and they wind the other way.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { 589.3 }  max_trace_level 20  adc_bailout 1e-7  exposure 1.5 }

#declare Thickness = 4;       // mm, of each plate
#declare View = 0.6;          // tangents
#declare Wide = 600;          // mm
camera { location -1000*z  direction z  right View*x  up View*y }
#declare Sheet = polygon {
  5, <-Wide, -Wide, 0>, <Wide, -Wide, 0>, <Wide, Wide, 0>, <-Wide, Wide, 0>, <-Wide, -Wide, 0> }
object { Sheet translate z  luminous { spectrum { e } polarizer { ideal axis x } } }
object { Sheet translate -20*z  polarizer { ideal axis y } }
box { <-Wide, -Wide, -Thickness>, <Wide, Wide, 0>  interior { M_Quartz_Right optic_axis z }  optical_contact }
box { <-Wide, -Wide, -2*Thickness>, <Wide, Wide, -Thickness>  interior { M_Quartz_Left optic_axis z }  optical_contact }

// ---- what it must give ----------------------------------------------------------------------------
// A plate is exp of its retardation D and rotation r: in (s, p), with h = sqrt((D/2)^2 + r^2), b = D/2 sin(h)/h, g
// = r sin(h)/h, ((cos h + i b, g), (-g, cos h - i b)), the left one with -g; light that meets the right plate
// first and is seen at the azimuth f passes 4 b^2 (cos(h) sin 2f + g cos 2f)^2: dark where tan 2f = -g/cos h.
// Gyration at angle psi from the axis: g33 cos^2 + g11 sin^2 (Born & Wolf 15.4; Szivessy & Muenster 1934); between
// the faces once, T_s T_p; what comes by further orders is less than the tolerance.
#macro Retardation_2(Q)
  #local N_O = Quartz_O(589.3);
  (pi*(N_O*sqrt(1 - pow(Q/Quartz_E(589.3), 2)) - sqrt(N_O*N_O - Q*Q))*Thickness/(589.3*nm))
#end
#macro Rotation(Q)
  #local Sine_2 = pow(Q/Quartz_O(589.3), 2);
  (radians(Lowry_Deg_Per_Mm(589.3))*(1 - Sine_2 - 0.449*Sine_2)*Thickness/sqrt(1 - Sine_2))
#end
#macro Expect_Spiral(Tan, Azimuth_Deg)
  #local F = radians(Azimuth_Deg);
  #local Q = Tan/sqrt(1 + Tan*Tan);
  #local D = Retardation_2(Q);
  #local H = sqrt(D*D + pow(Rotation(Q), 2));
  #local B = D*sin(H)/H;
  #local G = Rotation(Q)*sin(H)/H;
  #local Faces = S_Face_T(1, Quartz_O(589.3), Q)*P_Face_T(1, 1, pow(Quartz_O(589.3), 2), pow(Quartz_E(589.3), 2), Q, 0);
  expect {
    relative_radiance 589.3, 2*B*B*Faces*pow(cos(H)*sin(2*F) + G*cos(2*F), 2)
    at <0.5 + Tan*cos(F)/View, 0.5 - Tan*sin(F)/View> within 2e-3
    source "two plates of opposite hand: Airy 1831; Lowry's rotation, Ghosh's indices"
  }
#end
#for (I, 1, 6)
  #for (Azimuth, -45, 60, 35)
    Expect_Spiral(0.04*I, Azimuth)
  #end
#end
expect { relative_radiance 589.3, 0 within 1e-6 source "along the axis the two rotations cancel" }
