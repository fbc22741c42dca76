// Figure 9, right: as figure 7 from camera 2, full colour, 380 to 780 nm by 20 nm.
#version unofficial 3.7;
#declare Rotation_Scale = 75;
#declare Tilt = 10;
#include "founding.inc"
global_settings { mm_per_unit Mm_Per_Unit max_trace_level 30 adc_bailout 1e-7 exposure 2 }
Founding_Camera(Centre, View_Angle)

#for (Lambda, 380, 780, 40)
  Expect_Centre(Lambda, 1e-4)
#end
