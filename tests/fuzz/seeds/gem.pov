global_settings { mm_per_unit 1 wavelengths { 550 } }
camera { location <0, 20, 0> sky z look_at 0 angle 30 }
gem { index_gear 8 facet { angle -45 index 0, 2, 4, 6 distance 1 } facet { angle 40 index 1, 3, 5, 7 distance 1 } facet { angle 90 index 0, 1, 2, 3, 4, 5, 6, 7 distance 1 } table 0.5 size 4
  interior { ior 2.4 } }
crystal { cdl "cubic[m3m]:{111} + {100}@1.2" translate 9*x interior { ior 1.4 } }
crystal { facet x, 1 facet -x, 1 facet y, 1 facet -y, 1 facet z, 1 facet -z, 1 translate -9*x interior { ior 1.4 } }
