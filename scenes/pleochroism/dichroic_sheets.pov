// Dichroic sheets, as of stretched polyvinyl alcohol with iodine: a medium of one index that absorbs what vibrates
// along its chains 500 times as strongly as the rest. Two sheets over a plain lamp: crossed on the left, parallel
// on the right, at 45 deg in the middle. No polarizer of the scene language is in here. Look for: black, half of
// one sheet, one sheet.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 50 }
  max_trace_level 20  adc_bailout 1e-8  exposure 1.6 }

#declare Thickness = 0.1;     // mm
#declare View = 20;           // mm
camera { orthographic  location -40*z  look_at 0  right View*x  up View*y }
polygon { 5, <-9.5, -9, 2>, <9.5, -9, 2>, <9.5, 9, 2>, <-9.5, 9, 2>, <-9.5, -9, 2>  luminous { spectrum { d65 } } }
box { <-9, -4, -Thickness>, <9, 8, 0>  interior { M_Polaroid optic_axis x } }
#declare Upper = box { <-2.5, -8, -Thickness>, <2.5, 4, 0>  translate -z }
object { Upper translate -6*x  interior { M_Polaroid optic_axis y } }
object { Upper interior { M_Polaroid optic_axis <1, 1, 0> } }
object { Upper translate 6*x   interior { M_Polaroid optic_axis x } }

// ---- what it must give ----------------------------------------------------------------------------
// Beer's law for both vibrations of each sheet, with Fresnel, all orders in each sheet and between the two.
#declare R = Normal_R(1, 1.5);
// principal transmittances of HN-32 with its two faces (Shurcliff 1962, at 550 nm), these 0.92 taken out: one way
#declare Along_Once = 0.00002/0.92;
#declare Across_Once = 0.70/0.92;
#macro Sheet_T(Once) (Absorbing_Plate_T(1.5, Once)) #end
#macro Sheet_R(Once) (R*(1 + pow((1 - R)*Once, 2)/(1 - pow(R*Once, 2)))) #end
#macro Two_T(Once_1, Once_2) (Sheet_T(Once_1)*Sheet_T(Once_2)/(1 - Sheet_R(Once_1)*Sheet_R(Once_2))) #end
#declare One_Up = Sheet_T(Across_Once);
#declare One_Right = Sheet_T(Along_Once);
expect { stokes 550, <One_Up + One_Right, One_Right - One_Up, 0, 0>/2 at <0.5, 0.15> within 1e-6 source "one sheet: Beer, Fresnel" }
expect { relative_radiance 550, Two_T(Along_Once, Across_Once) at <0.2, 0.5> within 1e-6 source "crossed" }
expect {
  relative_radiance 550, (Two_T(Along_Once, Along_Once) + Two_T(Across_Once, Across_Once))/2 at <0.8, 0.5> within 1e-6
  source "parallel"
}
expect { relative_radiance 550, pow(One_Up/2, 2) at <0.5, 0.5> within 0.001 source "Malus at 45 deg, but for the orders between the sheets" }
