// Glan and Taylor's polarizer: two prisms of calcite with an air gap at 40 deg, their optic axis in the plane of
// the picture's right and the light. The ordinary wave is reflected totally (critical angle 37.1 deg), the
// extraordinary one passes close to Brewster's angle. Look for: the lamp through the prism at about 0.4 of its
// radiance, wholly polarized to the right: the crossed analyzer over the lower half makes it black.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { 589.3 }  max_trace_level 40  adc_bailout 1e-7  exposure 1.6 }

#declare N_O = 1.65835;
#declare N_E = 1.48640;
#declare Calcite = interior {
  ordinary { constant N_O } extraordinary { constant N_E } optic_axis x
  source "calcite at 589.3 nm, as in handbooks"
}
#declare View = 16;           // mm
#declare Tilt = 40;           // deg, between the light and the gap's normal
camera { orthographic  location -50*z  look_at 0  right View*x  up View*y }
polygon { 5, <-7.5, -7, 9>, <7.5, -7, 9>, <7.5, 7, 9>, <-7.5, 7, 9>, <-7.5, -7, 9>  luminous { spectrum { e } } }
polygon { 5, <-7, -6, -9>, <7, -6, -9>, <7, 0, -9>, <-7, 0, -9>, <-7, -6, -9>  polarizer { ideal axis y } }

#declare Slope = 5*tan(radians(Tilt));
#declare Back = Slope + 0.5;
prism { -5, 5, 5, <-5, -Back>, <5, -Back>, <5, -Slope>, <-5, Slope>, <-5, -Back>  interior { Calcite } }
prism { -5, 5, 5, <-5, Slope>, <5, -Slope>, <5, Back>, <-5, Back>, <-5, Slope>  interior { Calcite } }
// Blackened sides: what the gap throws aside would come back by the sides and end as 0.2 % of false light.
#declare Black = interior { ior N_O  absorption { constant 30 }  source "black cement of the ordinary index; its depth is a choice" }
box { <-6, -5, -Back>, <-5, 5, Back>  interior { Black }  optical_contact }
box { <5, -5, -Back>, <6, 5, Back>  interior { Black }  optical_contact }

// ---- what it must give ----------------------------------------------------------------------------
// Each face of the gap passes T_Face of the extraordinary wave; all orders in the gap, then all orders between the
// two ends (what the gap reflects leaves sideways).
#declare T_Face = P_Face_T(N_E*N_E, N_O*N_O, 1, 1, -N_E*sin(radians(Tilt)), Tilt);
#declare T_Gap = T_Face/(2 - T_Face);
#declare R_End = Normal_R(1, N_E);
#declare T = pow(1 - R_End, 2)*T_Gap/(1 - pow(R_End*T_Gap, 2));
// Once through both ends and both faces of the gap 0.7934623 passes; the reflections between them add half a percent.
#declare Once = pow((1 - R_End)*T_Face, 2);
#if (abs(Once - 0.7934623) > 1e-7) #error concat("once through the prism passes ", str(Once, 0, 7)) #end
expect {
  stokes 589.3, <T/2, T/2, 0, 0> at <0.5, 0.4> within 2e-6
  source "impedances of the extraordinary wave at the gap; all orders in the gap and between the ends"
}
expect { relative_radiance 589.3, 0 at <0.5, 0.6> within 2e-6 source "extinct behind the crossed analyzer" }
expect { relative_radiance 589.3, 0.5 at <0.5 - 6.5/View, 0.6> within 1e-6 source "the bare lamp behind the analyzer" }
