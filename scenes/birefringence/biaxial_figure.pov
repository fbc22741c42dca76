// The interference figure of aragonite: a plate across the acute bisectrix (c) between crossed polarizers at 45
// deg to the plane of its optic axes, seen under all angles up to 24 deg in sodium light. Look for: two eyes, the
// optic axes, 15.4 deg off the middle on both sides; Cassini's ovals and lemniscates about them; two dark brushes,
// the isogyres, through the eyes.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { 589.3 }  max_trace_level 20  adc_bailout 1e-7  exposure 1.5 }

#declare N_A = 1.530; #declare N_B = 1.681; #declare N_C = 1.6855;
#declare Thickness = 0.5;     // mm
#declare View = 0.9;          // tangents
#declare Wide = 600;          // mm
camera { location -1000*z  direction z  right View*x  up View*y }
#declare Sheet = polygon {
  5, <-Wide, -Wide, 0>, <Wide, -Wide, 0>, <Wide, Wide, 0>, <-Wide, Wide, 0>, <-Wide, -Wide, 0> }
object { Sheet translate z  luminous { spectrum { e } polarizer { ideal axis <1, 1, 0> } } }
object { Sheet translate -z  polarizer { ideal axis <1, -1, 0> } }
box { <-Wide, -Wide, -Thickness>, <Wide, Wide, 0>  
  interior {
    alpha { constant N_A } beta { constant N_B } gamma { constant N_C }
    optic_frame { alpha x gamma y }    // the crystal's X is towards the viewer, its Y to the right
    source "aragonite, 589.3 nm, as in handbooks"
  } }

// ---- what it must give ----------------------------------------------------------------------------
// On the line through both optic axes, Theta from the middle: a polarizer's axis across the ray is (1, cos
// Theta)/sqrt(1 + cos^2 Theta) on s and p. s vibrates along beta, p_s^2 = n_b^2 - q^2; p in the plane of gamma and
// alpha, p_p^2 = n_c^2 (1 - q^2/n_a^2), q = sin Theta; they gain (p_s - p_p) d on each other, order m 2m + 1 times
// that, and nothing on the optic axes, n_b sin V off.
#macro Figure(Q)
  #local Cos_2 = 1 - Q*Q;
  #local T_S = S_Face_T(1, N_B, Q);
  #local T_P = P_Face_T(1, 1, N_C*N_C, N_A*N_A, Q, 0);
  #local Phase = 2*pi*(sqrt(N_B*N_B - Q*Q) - N_C*sqrt(1 - Q*Q/(N_A*N_A)))*Thickness/(589.3*nm);
  #local Sum = 0;
  #for (M, 0, 3)
    #local A = T_S*pow(1 - T_S, M);
    #local B = T_P*pow(1 - T_P, M)*Cos_2;
    #local Sum = Sum + A*A + B*B - 2*A*B*cos((2*M + 1)*Phase);
  #end
  (Sum/2/pow(1 + Cos_2, 2))
#end
#for (I, -4, 4)
  #declare Tan = 0.1*I + 0.01;
  expect {
    relative_radiance 589.3, Figure(Tan/sqrt(1 + Tan*Tan)) at <0.5 + Tan/View, 0.5> within 1e-4
    source "Born & Wolf 15.4.3, polarizers and faces under the angle, all orders"
  }
#end
#declare Sine = N_B*cos(radians(Binormal_From_Gamma_Deg(N_A, N_B, N_C)));
#for (Side, -1, 1, 2)
  expect {
    relative_radiance 589.3, 0 at <0.5 + Side*Sine/sqrt(1 - Sine*Sine)/View, 0.5> within 1e-3
    source "an optic axis, 15.4 deg off: dark in every position"
  }
#end
