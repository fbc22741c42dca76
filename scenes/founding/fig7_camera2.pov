// Figure 7, right: camera 2, one wavelength (580 nm), rotation x 75.
#version unofficial 3.7;
#declare Founding_Spectrum = spectrum { line 580 }
#declare Rotation_Scale = 75;
#declare Tilt = 10;
#include "founding.inc"
global_settings { mm_per_unit Mm_Per_Unit max_trace_level 30 adc_bailout 1e-7 exposure 2 wavelengths { 580 } }
Founding_Camera(Centre, View_Angle)

Expect_Centre(580, 5e-5)
