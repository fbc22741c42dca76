// Figure 6, left: camera 2, tilted a little; edge 16 mm.
#version unofficial 3.7;
#declare Tilt = 10;
#include "founding.inc"
global_settings { mm_per_unit Mm_Per_Unit max_trace_level 30 adc_bailout 1e-7 exposure 2 }
Founding_Camera(Centre, View_Angle)

#for (Lambda, 380, 780, 40)
  Expect_Centre(Lambda, 2e-6)
#end
expect {
  malus_xyz Edge, <0.572, 0.544, 0.512> within 1 percent
  source "Kozlov & Debelov 2014: 16 mm between parallel polarizers under D65, before Fresnel losses (5 nm; steps of 20 nm cost 0.5 %)"
}
