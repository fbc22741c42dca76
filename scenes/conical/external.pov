// External conical refraction in aragonite: a plate cut across a biradial, a pinhole at its far side, and the eye
// close to a pinhole straight across at its near side. One ray leads from hole to hole, but a cone of wave normals
// belongs to it (1.74 deg), and each of them leaves in its own direction: the eye sees the hole as a ring, 2.92
// deg across. It is not where the hole is: one point of the ring, in the middle of the picture, is. Each of its
// points is linearly polarized, along the line that joins it to the middle. Nothing in here samples a cone: every
// pixel's two waves are enough.
#version unofficial 3.7;
#include "closed_forms.inc"
#declare Lambda = 589.3;
#declare N_A = 1.530; #declare N_B = 1.681; #declare N_C = 1.6855;
#declare Thickness = 30;      // mm
#declare Hole = 0.04;         // mm, radius
#declare View = 0.13;         // tangents: 7.4 deg
global_settings { mm_per_unit 1  wavelengths { Lambda }  max_trace_level 4  adc_bailout 1e-3  exposure 2 }
camera { location -(Thickness + 0.001)*z  direction z  right View*x  up View*y }
disc { 0.01*z, -z, Hole  luminous { spectrum { line Lambda } } }
#declare V = radians(Biradial_From_Gamma_Deg(N_A, N_B, N_C));
box {
  <-2*Thickness, -2*Thickness, -Thickness>, <2*Thickness, 2*Thickness, 0>
  interior {
    alpha { constant N_A } beta { constant N_B } gamma { constant N_C }
    optic_frame { alpha <sin(V), -cos(V), 0> gamma <cos(V), sin(V), 0> }
    source "aragonite, 589.3 nm, as in handbooks"
  }
}

// ---- what it must give ----------------------------------------------------------------------------
// With E = (sin psi, cos psi) across the biradial the tangential part of k is Span sin psi (sin psi, cos psi),
// outside and inside. One wave of the two meets the hole: half the light. Faces: as at normal incidence, for at
// most 3 deg of it (to 2e-3).
#declare Span = N_B*Tan_Normal_Cone(N_A, N_B, N_C);
#declare Half_Light = pow(1 - Normal_R(1, N_B), 2)/2;
#macro Expect_Point(Azimuth_Deg, Factor, On)
  #local A = radians(Azimuth_Deg);        // of E, and of the place seen from the middle
  #local Sine = Span*cos(A)*Factor;
  #local Place = Sine/sqrt(1 - Sine*Sine);
  expect {
    stokes Lambda, On*Half_Light*<1, cos(2*A), sin(2*A), 0>
    at <0.5 + Place*cos(A)/View, 0.5 - Place*sin(A)/View> within 2e-3
    source "wave normals of the biradial: Born & Wolf 15.3.4; E along the line to the middle"
  }
#end
#for (I, -3, 3)
  Expect_Point(25*I, 1, 1)
#end
Expect_Point(0, 0.5, 0)
Expect_Point(0, 1.1, 0)
Expect_Point(45, 1.15, 0)
Expect_Point(-45, 0.8, 0)
