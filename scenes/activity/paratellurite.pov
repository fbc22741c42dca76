// Paratellurite (TeO2) along its axis turns light by 105 deg/mm in the yellow and by 271 deg/mm in the violet,
// five to six times as much as quartz. Steps of 0.1 to 1 mm between crossed polarizers in daylight. Look for:
// greys and yellows within the first tenths of a millimetre, then colours that change with every step.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings {
  mm_per_unit Mm_Per_Unit
  wavelengths { 438.2, 463, 480, 499.5, 515, 530, 550, 570, 589.3, 610, 632.8, 650, 670, 700 }
  max_trace_level 40  adc_bailout 1e-7  exposure 2.5 }

#declare View = 20;           // mm
camera { orthographic  location -40*z  look_at 0  right View*x  up View*y }
polygon { 5, <-9.8, -9.5, 2>, <9.8, -9.5, 2>, <9.8, 9.5, 2>, <-9.8, 9.5, 2>, <-9.8, -9.5, 2>
  luminous { spectrum { d65 } polarizer { ideal axis y } } }
polygon { 5, <-9.8, -9.5, -5>, <9.8, -9.5, -5>, <9.8, 9.5, -5>, <-9.8, 9.5, -5>, <-9.8, -9.5, -5>
  polarizer { ideal axis x } }
#macro Place_X(Step) (-7.6 + 3.8*mod(Step - 1, 5)) #end
#macro Place_Y(Step) (Step > 5 ? 4.6 : -4.6) #end
#for (Step, 1, 10)
  box { <-1.7, -4, -0.1*Step>, <1.7, 4, 0>  translate <Place_X(Step), Place_Y(Step), 0>
    interior { M_Paratellurite_Right optic_axis z } }
#end

// ---- what it must give ----------------------------------------------------------------------------
#macro Paratellurite_O(Lambda)
  #local L2 = Lambda*Lambda*1e-6;
  (sqrt(1 + 2.584*L2/(L2 - 0.1342*0.1342) + 1.157*L2/(L2 - 0.2638*0.2638)))
#end
#macro Expect_Step(Step, Lambda, Deg_Per_Mm)
  expect {
    relative_radiance Lambda, Plate_T(Paratellurite_O(Lambda))/2*pow(sin(radians(Deg_Per_Mm*0.1*Step)), 2)
    at <0.5 + Place_X(Step)/View, 0.5 - Place_Y(Step)/View> within 1e-4
    source "rotation and n_o of Uchida 1971, Malus, all orders"
  }
#end
#for (Step, 1, 10, 3)
  Expect_Step(Step, 632.8, 86.9)
  Expect_Step(Step, 589.3, 104.9)
  Expect_Step(Step, 463, 221.1)
#end
