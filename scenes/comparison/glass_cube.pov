// A glass cube on a square light that carries a polarizer, before an analyzer: what another renderer can do too.
// tests/bench/mitsuba.py compares the time that nicol and Mitsuba take to a given error.
#version unofficial 3.7;
#ifndef (Dispersion) #declare Dispersion = 0; #end   // um^2; any at all makes nicol trace each wavelength
global_settings { mm_per_unit 10 wavelengths { from 400 to 699 step 13 } max_trace_level 64 adc_bailout 1e-4 }
camera { location <2.2, 2, -2.6> right x angle 24 look_at <0, 0.45, 0> polarizer { ideal angle 0 projection absorption } }
background { spectrum { e scale 0.1 } }
polygon { 5, <-1, 0, -1>, <1, 0, -1>, <1, 0, 1>, <-1, 0, 1>, <-1, 0, -1>
  luminous { spectrum { e scale 2 } polarizer { ideal axis <cos(0.3), 0, sin(0.3)> projection absorption } } }
box { <-0.5, 0, -0.5>, <0.5, 1, 0.5> rotate -25*y interior { index { cauchy 1.52, Dispersion } } }
expect { relative_radiance 400, 0.025 at <0.01, 0.01> within 1e-6 source "the sky is not polarized: the analyzer passes half of it" }
