// Quartz looked through along its optic axis: right quartz above, left quartz below, 1 to 6 mm thick. The lamp is
// polarized to the right; an analyzer at 45 deg lies over the middle. Light turns by 21.7 deg/mm in the yellow and
// by twice as much in the violet, clockwise for the receiver in right quartz, counter-clockwise in left quartz.
// Look for: colours that run through the spectrum with thickness, and that right and left quartz show complements
// of each other; no colours where the analyzer does not lie.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings {
  mm_per_unit Mm_Per_Unit  max_trace_level 20  adc_bailout 1e-7  exposure 2
  wavelengths { 400, 420, 435.83, 460, 486.13, 500, 520, 546.07, 570, 588.995, 610, 632.8, 656.27, 680, 700 }
}
#declare View = 20;           // mm
camera { orthographic  location -30*z  look_at 0  right View*x  up View*y }
polygon { 5, <-10, -10, 1>, <10, -10, 1>, <10, 10, 1>, <-10, 10, 1>, <-10, -10, 1>
  luminous { spectrum { d65 } polarizer { ideal axis x } } }
polygon { 5, <-9.8, -6.5, -9>, <9.8, -6.5, -9>, <9.8, 6.5, -9>, <-9.8, 6.5, -9>, <-9.8, -6.5, -9>
  polarizer { ideal axis <1, 1, 0> } }
#macro Place_X(Thickness) (-8 + 3.2*(Thickness - 1)) #end
#for (Thickness, 1, 6)
  #declare Plate = box { <-1.4, -4, -Thickness>, <1.4, 4, 0>  translate Place_X(Thickness)*x }
  object { Plate translate  4.6*y  interior { M_Quartz_Right optic_axis z } }
  object { Plate translate -4.6*y  interior { M_Quartz_Left optic_axis z } }
#end

// ---- what it must give ----------------------------------------------------------------------------
// Along the axis both waves are circular with one impedance: Fresnel with n_o, all orders turned by the same
// angle, since the way there and back cancels.
#macro Expect_Rotation(Lambda, Thickness, Hand, Deg_Per_Mm, Whose)
  #local Azimuth = radians(-Hand*Deg_Per_Mm*Thickness);
  #local T = Plate_T(Quartz_O(Lambda));
  expect {
    stokes Lambda, <1, cos(2*Azimuth), sin(2*Azimuth), 0>*T/2
    at <0.5 + Place_X(Thickness)/View, 0.5 - Hand*8/View> within 2e-5
    source Whose
  }
  expect {
    relative_radiance Lambda, pow(cos(Azimuth - pi/4), 2)*T/2
    at <0.5 + Place_X(Thickness)/View, 0.5 - Hand*4/View> within 2e-5
    source concat(Whose, "; Malus behind the analyzer at +45 deg")
  }
#end
Expect_Rotation(588.995, 1, 1, 21.7492, "Lowry 1935: 21.7492 deg/mm at the line D2, right quartz clockwise")
#for (Hand, -1, 1, 2)
  #for (Thickness, 1, 6, 5)
    Expect_Rotation(435.83, Thickness, Hand, Lowry_Deg_Per_Mm(435.83), "Lowry's formula (1935)")
    Expect_Rotation(546.07, Thickness, Hand, Lowry_Deg_Per_Mm(546.07), "Lowry's formula (1935)")
    Expect_Rotation(656.27, Thickness, Hand, Lowry_Deg_Per_Mm(656.27), "Lowry's formula (1935)")
  #end
#end
