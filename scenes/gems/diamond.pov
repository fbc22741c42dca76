// A standard brilliant of diamond, Tolkowsky's proportions (1919), face up. What enters the table is totally
// reflected twice by the pavilion and comes back through table and crown: brilliance. It leaves at angles that
// depend on colour: fire. Look for: an eightfold pattern of facets that see a lamp and facets that see the dim
// room; the middle, where the smallest lamps are met in yellow and green only; blue and orange rims all about.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "minerals.inc"
#include "cuts.inc"
#declare Diameter = 6.5;      // mm: one carat
#declare View = 7.2;          // mm
#declare Dim = 0.06;
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 10 }
  max_trace_level 24  adc_bailout 2e-3  exposure 1.5 }
#include "face_up.inc"
object { Standard_Brilliant(Diameter, 0.53, 34.5, 40.75)  interior { M_Diamond } }

// ---- what it must give ----------------------------------------------------------------------------
#declare R = Diameter/2;
#declare Edge = R*0.02;
#declare Top = Edge + R*0.47*tan(radians(34.5));
Face_Up_Way(-0.1*R, 40.75, R, -Edge, Top)
// Peter 1923
#macro Diamond_N(Lambda)
  #local L2 = Lambda*Lambda*1e-6;
  (sqrt(1 + 0.3306*L2/(L2 - 0.1750*0.1750) + 4.3356*L2/(L2 - 0.1060*0.1060)))
#end
// small: 0.3 deg about where 550 nm leaves
#declare Out = Diamond_N(550)*Inside_Sine;
#for (Eighth, 0, 7)
  Lamp(Out, 45*Eighth, 5)
  #for (Ring, 1, 6)
    Lamp(0.14*Ring, 45*Eighth + 22.5 + 7*mod(Ring, 3) - 7, 40)
  #end
  Lamp(0.45, 45*Eighth, 30)
  Lamp(0.92, 45*Eighth, 30)
#end
// First way only; all other light is the room's, which is even: Dim + (1 - Dim) T/2 of each polarization.
#macro Expect_Fire(Lambda, Seen)
  #local N = Diamond_N(Lambda);
  #local In = 1 - Normal_R(1, N);
  #local P = In*P_Face_T(N*N, N*N, 1, 1, N*Inside_Sine, 0);
  #local S = In*S_Face_T(N, 1, Inside_Sine);
  expect {
    stokes Lambda, <Dim + Seen*(1 - Dim)*(P + S)/2, Seen*(1 - Dim)*(P - S)/2, 0, 0>
    at <0.5 - 0.1*R/View, 0.5> within 5e-4
    source "table, two total reflections, table: Snell and Fresnel with Peter's n (1923); a lamp of 0.6 deg holds the green alone"
  }
#end
Expect_Fire(550, 1)
Expect_Fire(540, 1)
Expect_Fire(430, 0)
Expect_Fire(680, 0)
