// A glass cube that turns with the clock.
#version unofficial 3.7;
#ifndef (Samples) #declare Samples = 1; #end
global_settings { mm_per_unit 1 wavelengths { 450, 550, 650 } max_trace_level 12 adc_bailout 1e-4 samples Samples }
camera { location <0, 30, -30> right x*image_width/image_height angle 30 look_at 0 }
background { spectrum { e scale 0.4 } }
polygon {
  5, <-8, 0, -8>, <8, 0, -8>, <8, 0, 8>, <-8, 0, 8>, <-8, 0, -8> luminous { spectrum { e } }
}
box { <-4, 0, -4>, <4, 6, 4> interior { ior 1.5 } rotate y*40*clock }
