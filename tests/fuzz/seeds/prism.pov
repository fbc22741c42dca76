global_settings { mm_per_unit 1 wavelengths { 550 } }
camera { orthographic location <0, 9, 0> sky z right 4*x up 4*y look_at 0 }
background { rgb 1 }
prism { linear_sweep 0, 1, 8, <0, 0>, <2, 0>, <2, 2>, <0, 0>, <3, 0>, <4, 0>, <4, 1>, <3, 0> interior { ior 1.5 dispersion 1.01 } }
intersection { plane { x, 1 } plane { -x, 1 } plane { y, 1 } plane { -y, 1 } plane { z, 3 } plane { -z, -2 } interior { ior 2 } }
merge { box { 5, 6 } box { 5.5, 7 } interior { index { constant 1.5 } } }
