// The same plate from behind, by a camera that is rolled: natural rotation has the same sense from either side,
// however the camera stands.
#version unofficial 3.7;
global_settings { mm_per_unit 1  wavelengths { 500 }  max_trace_level 10 }
#declare Roll = 40;   // deg
camera {
  location <0, 0, 30>  sky <sin(radians(Roll)), cos(radians(Roll)), 0>
  right x*image_width/image_height  angle 20  look_at 0
}
polygon { 5, <-8, -8, -10>, <8, -8, -10>, <8, 8, -10>, <-8, 8, -10>, <-8, -8, -10>
  luminous { spectrum { e } polarizer { ideal axis <sin(radians(Roll)), cos(radians(Roll)), 0> } } }
box { <-4, -4, 0>, <4, 4, 3> interior { ior 1  rotation { constant 10 } } }

// The light is polarized along the picture's up: azimuth 90 deg, turned clockwise to 60 deg.
#declare Azimuth = radians(90 - 10*3);
expect {
  stokes 500, <0.5, cos(2*Azimuth)/2, sin(2*Azimuth)/2, 0> within 1e-6
  source "dextrorotatory: clockwise facing the source (Biot 1812)"
}
