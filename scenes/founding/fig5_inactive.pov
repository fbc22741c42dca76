// Figure 5, left: camera 1 looks straight down on a cube without optical rotation. Colourless.
#version unofficial 3.7;
#declare Rotation_Scale = 0;
#include "founding.inc"
global_settings { mm_per_unit Mm_Per_Unit max_trace_level 30 adc_bailout 1e-7 exposure 2 }
Founding_Camera(Centre, View_Angle)

#for (Lambda, 380, 780, 40)
  expect {
    relative_radiance Lambda, On_Axis(Lambda, Edge/mm)
    within 2e-6 source "Malus, Fresnel, all orders between the two faces: formulas in founding.inc"
  }
#end
expect {
  chromaticity <0.3127, 0.3290> within 0.003
  source "CIE 15:2018, D65; steps of 20 nm, calcite and quartz move it by as much"
}
Expect_Bare_Light(580, 0.15, View_Angle)
Expect_Sky(580, 0.02, View_Angle)
