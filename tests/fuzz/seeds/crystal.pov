global_settings { mm_per_unit 1 wavelengths { 589 } coherence off conical_rays 4 conical_spread 0.1 }
camera { location <0, 0, -20> look_at 0 }
background { spectrum { table 400, 1, 700, 2 } }
crystal { axial_ratio { 1.09997 } point_group "32" size 4 left form { <1,0,-1,0>, 0.5 } form { <1,0,-1,1>, 1 } form { <0,1,-1,1>, 1.05 }
  interior { ordinary { constant 1.544 } extraordinary { constant 1.553 } rotation { constant 21 } gyration { ratio -0.5 } } }
