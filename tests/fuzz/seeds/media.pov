global_settings { mm_per_unit 1 wavelengths { 450, 550 } max_trace_level 2 }
camera { location <0, 0, -9> look_at 0 }
surroundings { interior { index { constant 1.33 } } }
#declare G = interior { index { sellmeier 1.04, 0.006, 0.23, 0.02, 1.01, 103.6 } absorption { table 400, 0.1, 700, 0.2 } range 300, 900 source "a" name "b" }
box { -1, 1 interior { G } } box { 2, 3 interior { index { table 400, 1.5, 700, 1.4 } extinction { constant 1e-5 } } }
box { 4, 5 interior { index { formula 3, 2.2, 0.01, -2 } rotation { biot 20, 0.1 } circular_waves left } }
box { 6, 7 interior { ordinary { constant 1.6 } extraordinary { constant 1.5 } optic_axis <1, 1, 0> gyration { tensor 1e-5, 1e-5, 2e-5, 0, 0, 0 at 589 } } }
