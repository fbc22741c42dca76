// Figure 6, right: camera 2; edge 8 mm about the same centre. Another hue: yellowish.
#version unofficial 3.7;
#declare Tilt = 10;
#declare Edge = 8;    // mm
#include "founding.inc"
global_settings { mm_per_unit Mm_Per_Unit max_trace_level 30 adc_bailout 1e-7 exposure 2 }
Founding_Camera(Centre, View_Angle)

#for (Lambda, 380, 780, 40)
  Expect_Centre(Lambda, 2e-6)
#end
expect {
  malus_xyz Edge, <0.757, 0.740, 0.438> within 1 percent
  source "Kozlov & Debelov 2014: 8 mm between parallel polarizers under D65, before Fresnel losses (5 nm; steps of 20 nm cost 0.5 %)"
}
