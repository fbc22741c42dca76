// Fresnel's rhomb (1822): two total reflections, each of which holds the light in the plane of incidence back by
// 45 deg against that across it, turn light polarized at 45 deg into circular light, at every wavelength that the
// glass has this index for. n = 1.49661 is the smallest index that does so, at 51.782 deg, where the shift is
// greatest and hardly depends on the angle. Look for: the lamp shows through, moved sideways by the rhomb, and is
// equally bright behind an analyzer (the polygons on its lower half) however that is turned; beside it the bare
// lamp, which a crossed analyzer puts out.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { 589.3 }  max_trace_level 30  adc_bailout 1e-9  exposure 2 }

#declare N = 1.49661;
#declare Incidence = 51.782;  // deg
#declare View = 30;           // mm
camera { orthographic  location -60*z  look_at 0  right View*x  up View*y }

// Cross-section in x and z: both ends face the light, the sides make 90 - Incidence with it.
#declare Width = 8;
#declare Aslant = radians(90 - Incidence);
#declare Length = 2*Width*pow(cos(Aslant), 2)/sin(Aslant);
#declare Over = Length*sin(Aslant);
#declare Deep = Length*cos(Aslant);
#declare From = -11;          // x of the upper end
prism {
  -6, 6, 5, <From, -Deep>, <From + Width, -Deep>, <From + Width + Over, 0>, <From + Over, 0>, <From, -Deep>
  interior { ior N }
}
polygon { 5, <-14, -8, 2>, <14, -8, 2>, <14, 8, 2>, <-14, 8, 2>, <-14, -8, 2>
  luminous { spectrum { e } polarizer { ideal axis <1, 1, 0> } } }

// Analyzers: across the lamp's plane, at 0 deg, and along it.
#declare Strip = polygon { 5, <-1.2, -6, 0>, <1.2, -6, 0>, <1.2, 0, 0>, <-1.2, 0, 0>, <-1.2, -6, 0> }
#for (I, 0, 2)
  object { Strip translate <From + 1.4 + 2.6*I, 0, -Deep - 2>  polarizer { ideal angle -45 + 45*I } }
  object { Strip scale <0.75, 1, 1> translate <8.2 + 2.3*I, 0, -Deep - 2>  polarizer { ideal angle -45 + 45*I } }
#end

// ---- what it must give ----------------------------------------------------------------------------
// tan(d/2) = cos th sqrt(sin^2 th - 1/n^2)/sin^2 th (Fresnel; Born & Wolf 1.5.4): d = 45 deg. Order m of the
// reflections between the ends passes 2m + 1 times 90 deg. The lamp is at +45 deg; what lies in the plane (x)
// lags, hence left circular.
#declare R = Normal_R(1, N);
#declare Middle = From + Width/2;
#declare Sine_2 = pow(sin(radians(Incidence)), 2);
#declare Shift = 2*atan2(cos(radians(Incidence))*sqrt(Sine_2 - 1/(N*N)), Sine_2);
#declare S_0 = 0; #declare S_2 = 0; #declare S_3 = 0;
#for (M, 0, 4)
  #declare Power = pow(1 - R, 2)*pow(R, 2*M)/2;
  #declare Phase = (2*M + 1)*2*Shift;
  #declare S_0 = S_0 + Power;
  #declare S_2 = S_2 + Power*cos(Phase);
  #declare S_3 = S_3 - Power*sin(Phase);
#end
expect {
  stokes 589.3, <S_0, 0, S_2, S_3> at <0.5 + Middle/View, 0.4> within 1e-6
  source "Fresnel's phase: left circular for a lamp at +45 deg, all orders between the ends"
}
expect {
  stokes 589.3, <S_0, 0, 0, -pow(1 - R, 2)/(1 + R*R)/2> at <0.5 + (Middle + 1)/View, 0.45> within 1e-5
  source "the same for 90 deg exactly: n = 1.49661 at 51.782 deg gives it to 1e-5"
}
#for (I, 0, 2)
  expect {
    relative_radiance 589.3, S_0/2 at <0.5 + (From + 1.4 + 2.6*I)/View, 0.6> within 1e-5
    source "circular light passes every analyzer by half"
  }
#end
expect { stokes 589.3, <0.5, 0, 0.5, 0> at <0.5 + 9/View, 0.4> within 1e-6 source "the bare lamp at +45 deg" }
