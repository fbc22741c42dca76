// Figure 7, left: camera 1, one wavelength (580 nm), rotation x 75. Light and dark bands, because the
// path through the crystal differs from pixel to pixel.
#version unofficial 3.7;
#declare Founding_Spectrum = spectrum { line 580 }
#declare Rotation_Scale = 75;
#include "founding.inc"
global_settings { mm_per_unit Mm_Per_Unit max_trace_level 30 adc_bailout 1e-7 exposure 2 wavelengths { 580 } }
Founding_Camera(Centre, View_Angle)

Expect_Centre(580, 5e-5)
expect {
  rotation_deg 580, 27008.17 within 0.01
  source "Kozlov & Debelov 2014: about 300 x 90 deg along the edge; 7.19 deg/mm, 0.0926283 um, 16 mm, x 75"
}
Expect_Bare_Light(580, 0.15, View_Angle)
Expect_Sky(580, 0.02, View_Angle)
