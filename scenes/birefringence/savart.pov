// Savart's plate: two equal plates of calcite at 45 deg to the axis, cemented with their principal sections crossed.
// What is ordinary in one is extraordinary in the other, so that both images move by the same d tan(walk-off), one
// up and one to the right. Look for: a double image along the diagonal, both halves equally bright, polarized
// across each other.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { 589.3 }  max_trace_level 40  adc_bailout 1e-8 }

#declare Thickness = 12;      // mm, of each plate
#declare View = 16;           // mm
camera { orthographic  location -60*z  look_at 0  right View*x  up View*y }
#declare Dot = 0.6;           // mm, radius
disc { 0, -z, Dot translate z  luminous { spectrum { e } } }
#for (Arm, 0, 5)
  disc { 0, -z, 0.3  translate 4.5*x  rotate 60*Arm*z  translate z  luminous { spectrum { e } } }
#end
#declare Half_Plate = box { <-6.5, -6.5, -Thickness>, <6.5, 6.5, 0> }
object { Half_Plate  interior { M_Calcite optic_axis <1, 0, -1> }  optical_contact }
object { Half_Plate  translate -Thickness*z  interior { M_Calcite optic_axis <0, 1, -1> }  optical_contact }

// ---- what it must give ----------------------------------------------------------------------------
// Three faces at normal incidence, all orders: 1/T = 1 + sum R/(1 - R) (all rays come back on themselves).
#declare N_O = Calcite_O(589.3);
#declare N_45 = Extraordinary_N(Calcite_O(589.3), Calcite_E(589.3), 45);
#declare Loss_O = Normal_R(1, N_O)/(1 - Normal_R(1, N_O));
#declare Loss_45 = Normal_R(1, N_45)/(1 - Normal_R(1, N_45));
#declare Loss_Between = Normal_R(N_O, N_45)/(1 - Normal_R(N_O, N_45));
#declare T = 1/(1 + Loss_O + Loss_45 + Loss_Between);
#declare Aside = Thickness*Tan_Walk_Off(Calcite_O(589.3), Calcite_E(589.3), 45);
#macro Expect_At(X, Y, S_1, S_0, Why)
  expect {
    stokes 589.3, <S_0, S_1, 0, 0> at <0.5 + (X)/View, 0.5 - (Y)/View> within 1e-6
    source Why
  }
#end
Expect_At(-Aside, 0, T/2, T/2, "extraordinary in the lower plate: moved along x, polarized along x; three faces, all orders")
Expect_At(0, -Aside, -T/2, T/2, "extraordinary in the upper plate: moved along y, polarized along y")
Expect_At(0, 0, 0, 0, "nothing where the dot is")
Expect_At(-Aside, -Aside, 0, 0, "nothing extraordinary twice")
Expect_At(-Aside + Dot - 0.005, 0, T/2, T/2, "its edge, inside: d tan(walk-off), Ghosh 1999's indices")
Expect_At(-Aside + Dot + 0.005, 0, 0, 0, "its edge, outside")
Expect_At(0, -Aside - Dot + 0.005, -T/2, T/2, "lower edge, inside")
Expect_At(0, -Aside - Dot - 0.005, 0, 0, "lower edge, outside")
