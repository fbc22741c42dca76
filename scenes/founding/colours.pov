// The colours that the paper names for 16 mm and 8 mm of quartz between parallel polarizers under D65, with
// wavelengths close enough for their last digit; and the white point. The picture is figure 5's.
#version unofficial 3.7;
#include "founding.inc"
global_settings {
  mm_per_unit Mm_Per_Unit max_trace_level 30 adc_bailout 1e-7 exposure 2
  wavelengths { from 380 to 780 step 5 }
}
Founding_Camera(Centre, View_Angle)

expect {
  malus_xyz 16*mm, <0.572, 0.544, 0.512> within 0.0006
  source "Kozlov & Debelov 2014: 16 mm between parallel polarizers under D65, before Fresnel losses"
}
expect {
  malus_xyz 8*mm, <0.757, 0.740, 0.438> within 0.0006
  source "Kozlov & Debelov 2014: 8 mm between parallel polarizers under D65, before Fresnel losses"
}
expect {
  chromaticity <0.3127, 0.3290> at <0.5, 0.02> within 0.0005
  source "CIE 15:2018, D65: the surroundings through the analyzer"
}
