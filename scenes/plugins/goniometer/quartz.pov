// A crystal of quartz from its angles, standing before light from behind a polarizer; optic axis along its c.
#version unofficial 3.7;
#include "minerals.inc"
global_settings { mm_per_unit 1  wavelengths { from 420 to 700 step 40 }  max_trace_level 12  adc_bailout 2e-3 }
camera { location <3, 3, -12>  look_at 0  right x*image_width/image_height  angle 32  polarizer { angle 0 } }
background { rgb 0.1 }
polygon { 5, <-9, -9, 0>, <9, -9, 0>, <9, 9, 0>, <-9, 9, 0>, <-9, -9, 0> translate 8*z
  luminous { spectrum { d65 } polarizer { angle 90 } } }
solid { plugin { "goniometer" file "quartz.gon" scale 1.25 } interior { M_Quartz_Right } rotate 20*y }
