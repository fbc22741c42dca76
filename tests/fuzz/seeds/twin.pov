global_settings { mm_per_unit 1 wavelengths { 589 } }
camera { location <0, 0, -20> look_at 0 }
crystal { cell { 5, 6, 7, 90, 100, 90 } point_group "2/m" form { <1,1,0>, 1 } form { <0,0,1>, 2 } facet <1,0,0>, 1.5
  twin { plane <1,0,0> contact <1,0,0> } interior { alpha { constant 1.5 } beta { constant 1.6 } gamma { constant 1.7 }
  optic_frame { beta b alpha c turn about b table { 400, 1, 700, 2 } } absorption { alpha { constant 0.1 } beta { constant 0.2 } gamma { constant 0 } } } }
