// Internal conical refraction in KTP, the crystal of today's experiments, in the red of a helium-neon laser: 30 mm
// across a binormal, which lies 18.228 deg from gamma's axis c by Kato and Takaoka's indices. If the plate were
// cut 0.03 deg off, there would be two dots and no ring. Look for: a ring of 0.97 mm.
#version unofficial 3.7;
#include "minerals.inc"
#declare Lambda = 632.8;
#ifndef (Azimuths) #declare Azimuths = 90; #end
// Kato & Takaoka, Appl. Opt. 41, 5040 (2002): n^2 = A + B/(l^2 - C) + D/(l^2 - E), l in um
#macro Kato_N(A, B, C, D, E)
  #local L2 = Lambda*Lambda*1e-6;
  (sqrt(A + B/(L2 - C) + D/(L2 - E)))
#end
#declare N_A = Kato_N(3.29100, 0.04140, 0.03978, 9.35522, 31.45571);
#declare N_B = Kato_N(3.45018, 0.04341, 0.04597, 16.98825, 39.43799);
#declare N_C = Kato_N(4.59423, 0.06206, 0.04763, 110.80672, 86.12171);
#declare Medium = interior { M_KTP }
#declare Thickness = 30;      // mm
#declare Hole = 0.1;          // mm, radius
#declare View = 1.5;          // mm
#declare Ring_Tolerance = 0.08;    // of 90 azimuths twelve meet the hole: one more or less
global_settings { mm_per_unit 1  wavelengths { Lambda }  max_trace_level 3  adc_bailout 1e-3  exposure 10
  conical_rays Azimuths  conical_spread 0.02 }
#include "conical.inc"
