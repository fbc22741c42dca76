// A brilliant of colourless sapphire, its optic axis along z (up in the picture), face up: a mild double image (birefringence
// 0.008), little fire (dispersion 0.018 against diamond's 0.044). Look for: the same pattern as the ruby's in clear light, its
// facets' edges a little doubled left and right of the middle.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "minerals.inc"
#include "cuts.inc"
#declare Diameter = 6;        // mm
#declare View = 6.6;          // mm
#declare Dim = 0.1;
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 20 }
  max_trace_level 14  adc_bailout 5e-3  exposure 0.7 }
#include "face_up.inc"
#declare Pavilion = 41;       // deg
#declare Table = 0.55;
object { Standard_Brilliant(Diameter, Table, 35, Pavilion)  interior { M_Sapphire  optic_axis z } }

// ---- what it must give ----------------------------------------------------------------------------
// In the plane of x and y both waves are as in glass: along z extraordinary, across it ordinary, each with its
// Beer's law.
#declare R = Diameter/2;
#declare Edge = R*0.02;
#declare Top = Edge + R*(1 - Table)*tan(radians(35));
#declare X_0 = -0.1*R;
Face_Up_Way(X_0, Pavilion, R, -Edge, Top)
// Malitson & Dodge 1972
#macro Corundum_N(B_1, C_1, B_2, C_2, B_3, C_3, Lambda)
  #local L2 = Lambda*Lambda*1e-6;
  (sqrt(1 + B_1*L2/(L2 - C_1*C_1) + B_2*L2/(L2 - C_2*C_2) + B_3*L2/(L2 - C_3*C_3)))
#end
#macro Corundum_O(Lambda) (Corundum_N(1.4313493, 0.0726631, 0.65054713, 0.1193242, 5.3414021, 18.028251, Lambda)) #end
#macro Corundum_E(Lambda) (Corundum_N(1.5039759, 0.0740288, 0.55069141, 0.1216529, 6.5927379, 20.072248, Lambda)) #end
#for (Eighth, 0, 7)
  Lamp(Corundum_O(600)*Inside_Sine, 45*Eighth, 40)
  Lamp(0.22, 45*Eighth + 22.5, 60)
  Lamp(0.75, 45*Eighth + 22.5, 60)
#end
#macro Once(N, T_Out) ((1 - Normal_R(1, N))*T_Out) #end
#for (Lambda, 460, 660, 100)
  #local N_O = Corundum_O(Lambda);
  #local N_E = Corundum_E(Lambda);
  #local P = Once(N_O, P_Face_T(N_O*N_O, N_O*N_O, 1, 1, N_O*Inside_Sine, 0));
  #local S = Once(N_E, S_Face_T(N_E, 1, Inside_Sine));
  expect {
    stokes Lambda, <(P + S)/2, (P - S)/2, 0, 0> + Dim*<Normal_R(1, N_O), 0, 0, 0> at <0.5 + X_0/View, 0.5> within 0.03
    source "the way by two total reflections: Snell, Fresnel; what comes the second time is at most 3 %, for nothing absorbs it"
  }
#end
