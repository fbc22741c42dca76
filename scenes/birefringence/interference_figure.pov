// The interference figure of calcite: a plate across the optic axis between crossed polarizers, seen under all
// angles up to 20 deg in sodium light. The plate is wide and far, so that each pixel takes in more than the two
// waves part: they interfere. Look for: a black cross where one of the two waves is missing, and rings where they
// have gained a whole wave on each other.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { 589.3 }  max_trace_level 20  adc_bailout 1e-7  exposure 1.5 }

#declare Thickness = 0.5;     // mm
#declare View = 0.72;         // tangents
#declare Wide = 600;          // mm
camera { location -1000*z  direction z  right View*x  up View*y }
#declare Sheet = polygon {
  5, <-Wide, -Wide, 0>, <Wide, -Wide, 0>, <Wide, Wide, 0>, <-Wide, Wide, 0>, <-Wide, -Wide, 0> }
object { Sheet translate z  luminous { spectrum { e } polarizer { ideal axis x } } }
object { Sheet translate -z  polarizer { ideal axis y } }
box { <-Wide, -Wide, -Thickness>, <Wide, Wide, 0>  interior { M_Calcite optic_axis z } }

// ---- what it must give ----------------------------------------------------------------------------
// At 45 deg to the polarizers, Theta from the axis: a polarizer's axis across the ray is (1, cos Theta)/sqrt(1 +
// cos^2 Theta) on s and p. The waves gain (p_o - p_e) d on each other, p_o^2 = n_o^2 - q^2, p_e^2 = n_o^2 (1 -
// q^2/n_e^2), q = sin Theta; order m 2m + 1 times that.
#declare N_O = Calcite_O(589.3);
#declare N_E = Calcite_E(589.3);
#macro Figure(Q)
  #local Cos_2 = 1 - Q*Q;
  #local T_S = S_Face_T(1, N_O, Q);
  #local T_P = P_Face_T(1, 1, N_O*N_O, N_E*N_E, Q, 0);
  #local Phase = 2*pi*(sqrt(N_O*N_O - Q*Q) - N_O*sqrt(1 - Q*Q/(N_E*N_E)))*Thickness/(589.3*nm);
  #local Sum = 0;
  #for (M, 0, 3)
    #local A = T_S*pow(1 - T_S, M);
    #local B = T_P*pow(1 - T_P, M)*Cos_2;
    #local Sum = Sum + A*A + B*B - 2*A*B*cos((2*M + 1)*Phase);
  #end
  (Sum/2/pow(1 + Cos_2, 2))
#end
#for (I, 1, 8)
  #declare Tan = 0.04*I;
  expect {
    relative_radiance 589.3, Figure(Tan/sqrt(1 + Tan*Tan)) at <0.5 + Tan/sqrt(2)/View, 0.5 - Tan/sqrt(2)/View> within 1e-4
    source "Born & Wolf 15.4.3 with Ghosh's indices, polarizers and faces under the angle, all orders"
  }
  expect { relative_radiance 589.3, 0 at <0.5 + Tan/View, 0.5> within 1e-6 source "the black cross, right arm" }
#end
expect { relative_radiance 589.3, 0 within 1e-6 source "the black cross, middle" }
