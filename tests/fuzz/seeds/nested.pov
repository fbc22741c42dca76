global_settings { mm_per_unit 1 wavelengths { 550 } }
camera { location <0, 0, -0.2> look_at z }
box { -4, 4 interior { ior 1.5 } }
box { -3, <3, 3, 0> interior { ior 1.3 } }
box { <-3, -3, 0>, 3 interior { ior 1.4 } }
polygon { 4, <-1, -1, 3>, <1, -1, 3>, <0, 1, 3>, <-1, -1, 3> luminous { spectrum { a scale 2 } } }
expect { relative_radiance 550, 0.4 at <0.02, 0.02> within 1e-6 source "none" }
