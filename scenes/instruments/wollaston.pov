// Wollaston's prism: two wedges of calcite, cemented, with their optic axes across the light and across each
// other. The light polarized to the right is extraordinary in the near wedge and ordinary in the far one, that
// polarized up the other way round: the slanted plane bends them to opposite sides. Look for: two images of the
// stripes, 5.3 deg apart, polarized across each other, with faint ones by double reflection between them; beside
// the prism the stripes.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { 589.3 }  max_trace_level 20  adc_bailout 1e-6  exposure 1.6 }

#declare View = 24;           // mm
#declare Tilt = 15;           // deg, of the cemented plane
#declare Distance = 40;       // mm, from the prism to the stripes
camera { orthographic  location -50*z  look_at 0  right View*x  up View*y }
#declare Half = 0.4;          // mm, half the width of a stripe
#for (I, -1, 1)
  polygon { 5, <-Half, -9, 0>, <Half, -9, 0>, <Half, 9, 0>, <-Half, 9, 0>, <-Half, -9, 0>
    translate <6*I, 0, Distance>  luminous { spectrum { e } } }
#end

#declare Slope = 10*tan(radians(Tilt));
#declare Back = Slope + 1;
prism { -6, 6, 5, <-10, -Back>, <10, -Back>, <10, -Slope>, <-10, Slope>, <-10, -Back>
  interior { M_Calcite optic_axis x }  optical_contact }
prism { -6, 6, 5, <-10, Slope>, <10, -Slope>, <10, Back>, <-10, Back>, <-10, Slope>
  interior { M_Calcite optic_axis y }  optical_contact }

// ---- what it must give ----------------------------------------------------------------------------
// From the camera: normal to the first face, then the plane whose normal is (sin Tilt, 0, cos Tilt), then out at
// the last face by k_x. Both waves are as in isotropic media but for the extraordinary one's impedance at the
// plane (closed_forms.inc).
#declare N_O = Calcite_O(589.3);
#declare N_E = Calcite_E(589.3);
#declare Sine = sin(radians(Tilt));
#declare Cosine = cos(radians(Tilt));
// k_x beyond the plane for index N_1 before it and N_2 beyond
#macro K_X(N_1, N_2) (Sine*sqrt(N_2*N_2 - pow(N_1*Sine, 2)) - N_1*Sine*Cosine) #end
// where the ray through the plane at X meets the stripes
#macro Lands_At(X, N_1, N_2)
  #local Q = K_X(N_1, N_2);
  (X + (Back + X*tan(radians(Tilt)))*Q/sqrt(N_2*N_2 - Q*Q) + (Distance - Back)*Q/sqrt(1 - Q*Q))
#end
#declare T_Up = (1 - Normal_R(1, N_O))*S_Face_T(N_O, N_E, Sine)*S_Face_T(N_E, 1, K_X(N_O, N_E)/N_E);
#declare T_Right = (1 - Normal_R(1, N_E))*P_Face_T(N_E*N_E, N_O*N_O, N_O*N_O, N_O*N_O, -N_E*Sine, Tilt)
  *P_Face_T(N_O*N_O, N_O*N_O, 1, 1, K_X(N_E, N_O), 0);
// where the camera must look to meet X_Stripe: Lands_At is linear in X
#macro Looks_At(X_Stripe, N_1, N_2)
  #local At_0 = Lands_At(0, N_1, N_2);
  ((X_Stripe - At_0)/(Lands_At(1, N_1, N_2) - At_0))
#end
#macro Expect_At(X, S_0, S_1, Why)
  expect { stokes 589.3, <S_0, S_1, 0, 0> at <0.5 + (X)/View, 0.5> within 2e-6 source Why }
#end
#declare Hair = 0.005;        // mm
#for (Side, -1, 1, 2)
  Expect_At(Looks_At(Side*(Half - Hair), N_O, N_E), T_Up/2, -T_Up/2, "Snell n_o to n_e, then to air; Fresnel across the plane of incidence")
  Expect_At(Looks_At(Side*(Half + Hair), N_O, N_E), 0, 0, "just outside that image")
  Expect_At(Looks_At(Side*(Half - Hair), N_E, N_O), T_Right/2, T_Right/2, "Snell n_e to n_o, then to air; impedances in the plane of incidence")
  Expect_At(Looks_At(Side*(Half + Hair), N_E, N_O), 0, 0, "just outside that image")
#end
