// A step cut (emerald cut) of emerald, its optic axis along its length, face up: the old cut for a soft, coloured
// stone. Broad steps lie like stairs in the depth. Look for: green, deeper where the way is longer; the middle of
// the keel, where light goes straight across and up again.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "minerals.inc"
#include "cuts.inc"
#declare Width = 6;           // mm
#declare Length = 8;          // mm
#declare View = 9;            // mm
#declare Dim = 0.1;
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 20 }
  max_trace_level 14  adc_bailout 3e-3  exposure 2 }
#include "face_up.inc"
#declare Pavilion = 60;       // deg; the steps below are 8 and 16 deg flatter
object { Step_Cut(Width, Length, 0.6, 0.15, 40, Pavilion, 0.04)  interior { M_Emerald optic_axis z } }
#for (Eighth, 0, 7)
  Lamp(0.12 + 0.06*mod(Eighth, 3), 45*Eighth, 60)
  Lamp(0.5, 45*Eighth + 22.5, 120)
  Lamp(0.8, 45*Eighth, 100)
#end

// ---- what it must give ----------------------------------------------------------------------------
// Across the keel: the third step is 44 deg steep, from the middle of a third of the width.
#declare W = Width/2;
#declare Edge = W*0.04;
#declare Top = Edge + W*0.4/3*(tan(radians(40)) + tan(radians(32)) + tan(radians(24)));
#declare Foot = -Edge - W/3*(tan(radians(60)) + tan(radians(52)));
#declare X_0 = -0.15*W;
Face_Up_Way(X_0, Pavilion - 16, W/3, Foot, Top)
#declare N_O = 1.583; #declare N_E = 1.577;      // Deer, Howie & Zussman
Lamp((N_O + N_E)/2*Inside_Sine, 0, 20)
#macro Once(N, T_Out, Alpha) ((1 - Normal_R(1, N))*T_Out*exp(-(Alpha)*Path)) #end
#for (Lambda, 440, 640, 100)
  #local P = Once(N_O, P_Face_T(N_O*N_O, N_O*N_O, 1, 1, N_O*Inside_Sine, 0),
    M_Band(Lambda, 0.40, 430, 4000) + M_Band(Lambda, 0.35, 600, 3000));
  #local S = Once(N_E, S_Face_T(N_E, 1, Inside_Sine),
    M_Band(Lambda, 0.25, 420, 4000) + M_Band(Lambda, 0.30, 630, 3000));
  expect {
    stokes Lambda, <(P + S)/2, (P - S)/2, 0, 0> + Dim*<Normal_R(1, N_O), 0, 0, 0> at <0.5 + X_0/View, 0.5> within 0.002
    source "the way by two total reflections: Snell, Fresnel, Beer; what comes the second time is less than 0.2 %"
  }
#end
