// Sodium chlorate, cubic and optically active, in its right and its left form: cubes with the faces of the
// tetrahedron, which the two forms have in opposite corners. Between crossed polarizers in the upper half each
// shows the same colour and is as bright in every direction; in the lower half the analyzer is turned by 30 deg,
// and the two are told apart.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 20 }
  max_trace_level 30  adc_bailout 1e-6  exposure 2.5 }

#declare Half = 8;            // mm, from the centre to the cube's faces
#declare Turned = 30;         // deg
#declare View = 44;           // mm
camera { orthographic  location -60*z  look_at 0  right View*x  up View*y }
polygon { 5, <-21, -12, 12>, <21, -12, 12>, <21, 12, 12>, <-21, 12, 12>, <-21, -12, 12>
  luminous { spectrum { d65 } polarizer { ideal axis y } } }
#macro Sheet(Y_1, Y_2, Axis)
  polygon { 5, <-21, Y_1, -20>, <21, Y_1, -20>, <21, Y_2, -20>, <-21, Y_2, -20>, <-21, Y_1, -20>
    polarizer { ideal axis Axis } }
#end
Sheet(0.1, 12, x)
Sheet(-12, -0.1, <cos(radians(Turned)), sin(radians(Turned)), 0>)
crystal {
  point_group "23"  size Half
  form { <1, 0, 0>, 1 }  form { <1, 1, 1>, 1.45 }
  translate -10*x  interior { M_Sodium_Chlorate_Right }
}
crystal {
  point_group "23"  size Half
  form { <1, 0, 0>, 1 }  form { <1, -1, 1>, 1.45 }
  translate 10*x  interior { M_Sodium_Chlorate_Right left }
}

// ---- what it must give ----------------------------------------------------------------------------
#declare N = 1.5151;
#macro Deg_Per_Mm(Lambda) (1.0368545*Lambda*Lambda*1e-6/pow(Lambda*Lambda*1e-6 - 0.0081, 2)) #end
#macro Expect_Crystal(Hand)
  #for (Lambda, 420, 680, 260)
    #local Azimuth = radians(90 - Hand*Deg_Per_Mm(Lambda)*2*Half);
    expect {
      relative_radiance Lambda, Plate_T(N)/2*pow(cos(Azimuth), 2)
      at <0.5 - Hand*10/View, 0.45> within 5e-5
      source "Malus with Chandrasekhar's rotation (1961), all orders"
    }
    expect {
      relative_radiance Lambda, Plate_T(N)/2*pow(cos(Azimuth - radians(Turned)), 2)
      at <0.5 - Hand*10/View, 0.55> within 5e-5
      source "the same, analyzer at 30 deg"
    }
  #end
#end
Expect_Crystal(1)
Expect_Crystal(-1)
