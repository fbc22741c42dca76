// Which way round: the senses that a picture must show, whatever happens in between. POV-Ray's space is
// left-handed, light and crystals are not.
#version unofficial 3.7;
global_settings { mm_per_unit 1  wavelengths { 500, 600 }  max_trace_level 10 }
camera { orthographic  location <0, 0, -20>  look_at 0  right 16*x  up 16*y }
#declare Lamp = polygon { 5, <-8, 0, 10>, <8, 0, 10>, <8, 8, 10>, <-8, 8, 10>, <-8, 0, 10> }

// Upper half: a light polarized along the picture's right and up.
object { Lamp luminous { spectrum { e } polarizer { ideal axis <1, 1, 0> } } }
expect {
  stokes 500, <0.5, 0, 0.5, 0> at <0.5, 0.25> within 1e-6
  source "S2 > 0: +45 deg, counter-clockwise from the picture's right"
}

// Lower half: a light polarized to the right, behind plates that turn it by 30 deg and do nothing else.
object { Lamp translate -8*y luminous { spectrum { e } polarizer { ideal axis x } } }
#declare Deg_Per_Mm = 10;
#declare Plate_Mm = 3;
#declare Turned = radians(Deg_Per_Mm*Plate_Mm);
#macro Plate(X, Rotation)
  box { <X, -7, 0>, <X + 4, -1, Plate_Mm> interior { ior 1  rotation { Rotation } } }
#end
#declare Right_Handed = rotation { constant Deg_Per_Mm }
#declare Left_Handed = rotation { constant Deg_Per_Mm left }
Plate(-7, Right_Handed)
Plate(3, Left_Handed)
expect {
  stokes 500, <0.5, 0.5, 0, 0> at <0.5, 0.75> within 1e-6
  source "no plate: horizontal, S1 > 0"
}
expect {
  stokes 500, <0.5, cos(2*Turned)/2, -sin(2*Turned)/2, 0> at <3/16, 0.75> within 1e-6
  source "dextrorotatory: clockwise facing the source (Biot 1812), the azimuth falls to -30 deg"
}
expect {
  stokes 600, <0.5, cos(2*Turned)/2, sin(2*Turned)/2, 0> at <13/16, 0.75> within 1e-6
  source "laevorotatory: counter-clockwise, the azimuth rises to +30 deg"
}
