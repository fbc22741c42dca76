// Quarter-wave (above) and half-wave plates (below) of quartz, zero order, in sodium light that is polarized to
// the right, their optic axes at 0, 15, 30 and 45 deg. A crossed analyzer lies over the middle of the picture.
// Look for: behind the analyzer nothing at 0 deg; from the quarter-wave plates up to half, from the half-wave
// plates up to all the light. The half-wave plates turn the plane by twice their angle; the quarter-wave plate at
// 45 deg makes circular light.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { 589.3 }  max_trace_level 20  adc_bailout 1e-8  exposure 2 }

#declare View = 20;           // mm
camera { orthographic  location -20*z  look_at 0  right View*x  up View*y }
polygon { 5, <-10, -10, 1>, <10, -10, 1>, <10, 10, 1>, <-10, 10, 1>, <-10, -10, 1>
  luminous { spectrum { e } polarizer { ideal axis x } } }
polygon { 5, <-9.8, -5, -1>, <9.8, -5, -1>, <9.8, 5, -1>, <-9.8, 5, -1>, <-9.8, -5, -1>
  polarizer { ideal axis y } }

#declare N_O = Quartz_O(589.3);
#declare N_E = Quartz_E(589.3);
#declare Wave = 589.3*nm/(N_E - N_O);    // thickness for a whole wave
#macro Place_X(I) (-7.5 + 5*I) #end
#for (I, 0, 3)
  #declare Angle = radians(15*I);
  #for (Kind, 1, 2)
    box { <Place_X(I) - 2, -8.5, -Wave*Kind/4>, <Place_X(I) + 2, -1, 0>  translate (Kind = 1 ? 9.5 : 0)*y
      interior { M_Quartz_Inactive optic_axis <cos(Angle), sin(Angle), 0> } }
  #end
#end

// ---- what it must give ----------------------------------------------------------------------------
// Jones: along the axis (1 - R_e) cos a exp(i d), across it -(1 - R_o) sin a; order m of the reflections between
// the faces has R_e^m, R_o^m and (2m + 1) d. Stokes vectors of the orders add; turned back by a.
#macro Expect_Plate(I, Kind)
  #local A = radians(15*I);
  #local S_0 = 0; #local S_1 = 0; #local S_2 = 0; #local S_3 = 0;
  #for (M, 0, 3)
    #local R_E = Normal_R(1, N_E);
    #local R_O = Normal_R(1, N_O);
    #local Along = (1 - R_E)*pow(R_E, M)*cos(A);
    #local Across = -(1 - R_O)*pow(R_O, M)*sin(A);
    #local Phase = (2*M + 1)*2*pi*Kind/4;
    #local S_0 = S_0 + Along*Along + Across*Across;
    #local S_1 = S_1 + Along*Along - Across*Across;
    #local S_2 = S_2 + 2*Along*Across*cos(Phase);
    #local S_3 = S_3 + 2*Along*Across*sin(Phase);
  #end
  expect {
    stokes 589.3, <S_0, S_1*cos(2*A) - S_2*sin(2*A), S_1*sin(2*A) + S_2*cos(2*A), S_3>/2
    at <0.5 + Place_X(I)/View, (Kind = 1 ? 0.12 : 0.88)> within 2e-6
    source "Jones, with Fresnel at both faces, all orders"
  }
  expect {
    relative_radiance 589.3, (S_0 - S_1*cos(2*A) + S_2*sin(2*A))/4
    at <0.5 + Place_X(I)/View, (Kind = 1 ? 0.3 : 0.7)> within 2e-6
    source "the same behind the crossed analyzer"
  }
#end
#for (I, 0, 3)
  Expect_Plate(I, 1)
  Expect_Plate(I, 2)
#end
