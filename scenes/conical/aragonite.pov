// Internal conical refraction in aragonite: a plate of 30 mm across a binormal makes a ring of 1.00 mm of a
// pinhole, by a cone of 1.90 deg (Lloyd saw 1 deg 50' in 1832). Look for: a closed ring, the hole's own place at
// its left end. Its polarization turns half as fast as the place on it: up and down at the left end, to the right
// at the right end.
#version unofficial 3.7;
#declare Lambda = 589.3;
#ifndef (Azimuths) #declare Azimuths = 90; #end
#declare N_A = 1.530; #declare N_B = 1.681; #declare N_C = 1.6855;
#declare Medium = interior {
  alpha { constant N_A } beta { constant N_B } gamma { constant N_C }
  source "aragonite, 589.3 nm, as in handbooks"
}
#declare Thickness = 30;      // mm
#declare Hole = 0.1;          // mm, radius
#declare View = 1.5;          // mm
#declare Ring_Tolerance = 0.08;    // of 90 azimuths twelve meet the hole: one more or less
global_settings { mm_per_unit 1  wavelengths { Lambda }  max_trace_level 3  adc_bailout 1e-3  exposure 10
  conical_rays Azimuths  conical_spread 0.02 }
#include "conical.inc"
