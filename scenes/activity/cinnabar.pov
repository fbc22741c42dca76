// Cinnabar (HgS) turns red light by 315 deg/mm along its axis, fifteen times as much as quartz turns yellow light:
// half a millimetre turns it nearly half round. Steps of 0.05 to 0.5 mm in the red of a helium-neon laser between
// crossed polarizers. Look for: dark where the rotation is a multiple of 180 deg, and that even the bright steps
// stay below 0.6 of the light: n_o = 2.9 reflects a quarter at each face.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { 632.8 }  max_trace_level 60  adc_bailout 1e-8  exposure 1 }

#declare View = 20;           // mm
camera { orthographic  location -40*z  look_at 0  right View*x  up View*y }
polygon { 5, <-9.8, -9.5, 2>, <9.8, -9.5, 2>, <9.8, 9.5, 2>, <-9.8, 9.5, 2>, <-9.8, -9.5, 2>
  luminous { spectrum { line 632.8 } polarizer { ideal axis y } } }
polygon { 5, <-9.8, -9.5, -5>, <9.8, -9.5, -5>, <9.8, 9.5, -5>, <-9.8, 9.5, -5>, <-9.8, -9.5, -5>
  polarizer { ideal axis x } }
#macro Place_X(Step) (-7.6 + 3.8*mod(Step - 1, 5)) #end
#macro Place_Y(Step) (Step > 5 ? 4.6 : -4.6) #end
#for (Step, 1, 10)
  box { <-1.7, -4, -0.05*Step>, <1.7, 4, 0>  translate <Place_X(Step), Place_Y(Step), 0>
    interior { M_Cinnabar_Right optic_axis z } }
#end

// ---- what it must give ----------------------------------------------------------------------------
// n_o: Bond, Boyd & Carter 1967, in the formula that minerals.inc has.
#declare L2 = 0.6328*0.6328;
#declare N_O = sqrt(4.1506 + 2.7896*L2/(L2 - 0.1328) + 1.1378*L2/(L2 - 705));
#for (Step, 1, 10, 3)
  expect {
    relative_radiance 632.8, Plate_T(N_O)/2*pow(sin(radians(315*0.05*Step)), 2)
    at <0.5 + Place_X(Step)/View, 0.5 - Place_Y(Step)/View> within 1e-4
    source "315 deg/mm (Groth 1906), n_o of Bond et al. 1967, Malus, all orders"
  }
#end
