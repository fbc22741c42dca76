global_settings { mm_per_unit 1 wavelengths { 500, 600 } max_trace_level 3 }
camera { location <0, 3, -9> look_at 0 angle 40 }
background { spectrum { e } }
difference { box { -1, 1 } box { <-0.5, -2, -0.5>, <0.5, 2, 0.5> } plane { <1, 1, 0>, -0.8 } rotate 30*y interior { ior 1.5 } }
box { <1, -1, -1>, <2, 1, 1> optical_contact interior { ior 1.6 } rotate 30*y }
