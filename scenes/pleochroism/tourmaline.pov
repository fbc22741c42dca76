// A plate of green tourmaline, 8 mm, its optic axis up and down, before a lamp that is polarized up (left), to the
// right (right) and not at all (middle). What vibrates across the axis is absorbed ten times as strongly: the
// plate is a polarizer (Biot 1815), as in tourmaline tongs. Below, a second plate lies across the first, so that
// all light is ordinary in one of the two. Look for: left pale green, right and below dark, but for the green
// between tourmaline's two bands, of which one plate lets 5 % through.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 20 }
  max_trace_level 20  adc_bailout 1e-5  exposure 1.6 }

#declare Thickness = 8;       // mm
#declare View = 20;           // mm
camera { orthographic  location -40*z  look_at 0  right View*x  up View*y }
#declare Third = polygon { 5, <-3, -9, 2>, <3, -9, 2>, <3, 9, 2>, <-3, 9, 2>, <-3, -9, 2> }
object { Third luminous { spectrum { d65 } } }
object { Third translate -6.2*x luminous { spectrum { d65 } polarizer { ideal axis y } } }
object { Third translate  6.2*x luminous { spectrum { d65 } polarizer { ideal axis x } } }
box { <-8.5, -7.5, -Thickness>, <8.5, 7.5, 0>  interior { M_Tourmaline_Green optic_axis y } }
box { <-8.5, -7.5, -Thickness>, <8.5, -2, 0>  translate -10*z  interior { M_Tourmaline_Green optic_axis x } }

// ---- what it must give ----------------------------------------------------------------------------
// Beer's law along each axis, with Fresnel at both faces, all orders: (1 - R)^2 t/(1 - (R t)^2). Two plates: all
// orders between them as well, each with its own reflectance R + R (1 - R)^2 t^2/(1 - (R t)^2).
#macro Alpha_O(Lambda) (M_Band(Lambda, 2.0, 720, 5000) + M_Band(Lambda, 2.0, 415, 6000)) #end
#macro Alpha_E(Lambda) (M_Band(Lambda, 0.2, 720, 5000) + M_Band(Lambda, 0.2, 415, 6000)) #end
#macro Plate_R(N, T) (Normal_R(1, N)*(1 + pow((1 - Normal_R(1, N))*T, 2)/(1 - pow(Normal_R(1, N)*T, 2)))) #end
#for (Lambda, 440, 640, 100)
  #declare Once_O = exp(-Alpha_O(Lambda)*Thickness);
  #declare Once_E = exp(-Alpha_E(Lambda)*Thickness);
  #declare T_O = Absorbing_Plate_T(1.640, Once_O);
  #declare T_E = Absorbing_Plate_T(1.620, Once_E);
  expect { stokes Lambda, <T_E/2, -T_E/2, 0, 0> at <0.19, 0.4> within 2e-5 source "Beer, along the axis" }
  expect { stokes Lambda, <T_O/2,  T_O/2, 0, 0> at <0.81, 0.4> within 2e-5 source "Beer, across the axis" }
  expect { stokes Lambda, <T_E + T_O, T_O - T_E, 0, 0>/2 at <0.5, 0.4> within 2e-5 source "Beer, both" }
  // through both plates; up is extraordinary in the lower and ordinary in the upper plate
  #declare Both = T_O*T_E/(1 - Plate_R(1.640, Once_O)*Plate_R(1.620, Once_E));
  expect { stokes Lambda, <Both, 0, 0, 0> at <0.5, 0.7> within 1e-4 source "Beer, crossed plates, all orders" }
#end
