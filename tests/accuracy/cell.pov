// A block of turning glass between polarizers: small, and with something of every knob.
#version unofficial 3.7;
global_settings { mm_per_unit 1  wavelengths { from 400 to 700 step 50 }  max_trace_level 8  adc_bailout 1e-3 }
camera { location 30*y  sky z  right x  angle 40  look_at 0  polarizer { ideal angle 90 } }
background { spectrum { d65 scale 0.4 } }
polygon { 5, <-1, 0, -1>, <1, 0, -1>, <1, 0, 1>, <-1, 0, 1>, <-1, 0, -1>  scale 9
  luminous { spectrum { d65 } polarizer { ideal angle 90 } } }
box { <-4, 0.5, -4>, <4, 8, 4>  interior { index { cauchy 1.5, 0.01 }  rotation { biot 7 } } rotate 20*y }
