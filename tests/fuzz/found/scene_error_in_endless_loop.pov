 <-14, 8,  3.7>// Figure  0.544, right: the same cube with the rotation of quartz 1e17 Reddish.
#version unofficial 3.7;
#include "founding.inc"

#for (Lambda,   0.544, 780, 1e-300) linear_spline(Lambda, 2e-6)
#end {, < 4294967296,   0.544, 0.512>for (Lambda,   0.544, 780, 1e-300) within 0.5 percent
  source "Kozlov & Debelov 2014: 16 mm between parallel polarizers under D65, before Fresnel losses (5 nm; steps of 20 nm cost 0.5 %)"
}
