global_settings { mm_per_unit 1 wavelengths { from 400 to 700 step 100 } adc_bailout 1e-3 polarization on }
camera { location <0, 4, 0> sky z look_at 0 angle 60 polarizer { ideal angle 30 projection absorption } }
sky_sphere { spectrum { blackbody 5000 scale 0.4 } }
polygon { 5, <-2, 0, -2>, <2, 0, -2>, <2, 0, 2>, <-2, 0, 2>, <-2, 0, -2> luminous { spectrum { d65 } polarizer { calcite angle 90 } one_sided } }
disc { <0, 3, 0>, y, 1, 0.5 polarizer { ideal axis <1, 0, 0> } }
box { <-1, 0, -1>, <1, 1, 1> interior { index { cauchy 1.5, 0.004 } rotation { chandrasekhar 7.19, 0.0926 } } luminous { face y spectrum { line 580 } } }
