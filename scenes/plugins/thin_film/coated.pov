// Two dark blocks of glass under a white sky, the right one with a quarter wave of magnesium fluoride at 550 nm on its face: its reflection is
// weaker and purple, for red and blue light find no quarter wave.
//   bare    R of one face 4.26 % (n 1.52), coated 1.26 %: ((1.52 - 1.38^2)/(1.52 + 1.38^2))^2
#version unofficial 3.7;
global_settings { mm_per_unit 1  wavelengths { from 400 to 700 step 10 }  max_trace_level 12  adc_bailout 1e-6  exposure 12 }
camera { orthographic location 40*y look_at 0 sky z right 12*x up 6*z }
disc { 60*y, -y, 300 luminous { spectrum { d65 } } }
#declare Dark = interior { ior 1.52 absorption { constant 2 } }
box { <-5, -40, -2>, <-0.5, 0, 2> interior { Dark } }
box { <0.5, -40, -2>, <5, 0, 2> interior { Dark } surface { plugin { "thin_film" n 1.38 thickness_nm 99.64 } face y } }

expect { at <0.27, 0.5> relative_radiance 550, 0.04258 within 0.00002 source "Fresnel: ((n - 1)/(n + 1))^2" }
expect { at <0.73, 0.5> relative_radiance 550, 0.01260 within 0.00002 source "quarter wave (Macleod, Thin-Film Optical Filters, 3.1)" }
