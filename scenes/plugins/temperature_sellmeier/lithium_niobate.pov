// Two plates of lithium niobate, 24.5 deg C and 200 deg C, between crossed polarizers: wedges whose optic axis lies in the plate.
// The birefringence falls as the crystal warms up, so the fringes of the hot one (right) lie further apart.
#version unofficial 3.7;
global_settings { mm_per_unit 1  wavelengths { from 420 to 700 step 20 }  max_trace_level 4  adc_bailout 1e-3 }
camera { orthographic  location 10*y  sky z  right 4.4*x  up 4.4*z  look_at 0  polarizer { angle 45 } }
background { rgb 0 }
polygon { 5, <-3, 0, -3>, <3, 0, -3>, <3, 0, 3>, <-3, 0, 3>, <-3, 0, -3> translate -1*y
  luminous { spectrum { d65 } polarizer { angle 135 } } }
#macro Plate(X, Kelvin)
  prism { -1, 1, 5, <-0.9, 0>, <0.9, 0>, <0.9, 0.03>, <-0.9, 0.01>, <-0.9, 0>
    rotate -90*x translate X*x
    interior {
      ordinary { plugin { "temperature_sellmeier/lithium_niobate_ordinary" temperature Kelvin } }
      extraordinary { plugin { "temperature_sellmeier/lithium_niobate_extraordinary" temperature Kelvin } }
      optic_axis x } }
#end
Plate(-1.1, 297.65)
Plate(1.1, 473.15)
