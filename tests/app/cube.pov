// A glass cube over a square light: small enough for tests of the command line.
#version unofficial 3.7;
#ifndef (Sky) #declare Sky = 0.4; #end
global_settings { mm_per_unit 1 wavelengths { 450, 550, 650 } max_trace_level 12 adc_bailout 1e-4 }
camera { location <0, 30, -30> right x*image_width/image_height angle 30 look_at 0 }
background { spectrum { e scale Sky } }
polygon {
  5, <-8, 0, -8>, <8, 0, -8>, <8, 0, 8>, <-8, 0, 8>, <-8, 0, -8> luminous { spectrum { e } }
}
box { <-4, 0, -4>, <4, 6, 4> interior { ior 1.5 } }
expect { relative_radiance 550, 0.4 at <0.02, 0.02> within 1e-6 source "the sky's level" }
expect { stokes 450, <0.4, 0, 0, 0> at <0.98, 0.02> within 1e-6 source "the sky is not polarized" }
