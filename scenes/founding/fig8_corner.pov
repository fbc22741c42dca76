// Figure 8: close-up of a corner of figure 7. The bands are shifted against each other where the light
// met different side faces, because the reflections there changed its polarization differently.
#version unofficial 3.7;
#declare Founding_Spectrum = spectrum { line 580 }
#declare Rotation_Scale = 75;
#include "founding.inc"
global_settings { mm_per_unit Mm_Per_Unit max_trace_level 30 adc_bailout 1e-7 exposure 2 wavelengths { 580 } }

// The middle of the picture: on the upper face, nearer to the side x = 8 mm than to z = 8 mm.
#declare Corner_Target = <6.3*mm, Centre.y + Edge/2, 5.6*mm>;
Founding_Camera(Corner_Target, 9)

// Snell turns the ray towards the normal of the upper face; it ends on the side x = 8 mm.
#declare Ray = vnormalize(Corner_Target - Eye);
#declare Ray_In_X = Ray.x/Crystal_Index(580);
expect {
  rotation_deg 580, Rotation_Deg_Per_Mm(580)*(Edge/2 - Corner_Target.x)/mm/Ray_In_X
  within 0.001
  source "Chandrasekhar's rotation times the refracted chord up to the side face"
}
