// Wire grids over a white light: one passes half of it, two crossed ones nothing, and a third between those at 45 degrees lets light
// through again. Seen from above; the grids lie over each other as three overlapping discs, the third slid in from the right.
//   one grid       (T across + T along)/2
//   crossed        T across x T along of both: black
//   at 45 degrees  half of (T across)^2/2, and what the two throw to and fro: blue more than red, for across the wires red is
//                  thrown back a little, and that takes part (all bounces summed by hand: 0.2648 at 450, 0.2383 at 650 nm)
// Numbers at 550 nm by the grid's own equations (wire_grid.cl, tests/fragments/wire_grid_test.cpp): T across 0.910, T along 1.2e-4.
#version unofficial 3.7;
global_settings { mm_per_unit 1  wavelengths { from 400 to 700 step 25 }  max_trace_level 40  adc_bailout 1e-6 }
camera { orthographic location 40*y look_at 0 sky z right 16*x up 16*z }
polygon { 5, <-7.5, 0, -7.5>, <7.5, 0, -7.5>, <7.5, 0, 7.5>, <-7.5, 0, 7.5>, <-7.5, 0, -7.5> luminous { spectrum { d65 } } }

#macro Grid(Place, Turn)
  disc { Place, y, 4 polarizer { plugin { "wire_grid" period 140 width 60 height 180 } angle Turn } }
#end
Grid(<-2, 1, 0>, 0)
Grid(<1.5, 2, 2.2>, 45)
Grid(<1.5, 3, -2.2>, 90)

expect { at <0.14, 0.5> relative_radiance 550, 0.4550 within 0.0003 source "one grid: half of T across and along" }
expect { at <0.41, 0.33> relative_radiance 450, 0.2648 within 0.0003 source "two at 45 degrees, Jones matrices of all bounces" }
expect { at <0.41, 0.33> relative_radiance 650, 0.2383 within 0.0003 source "the same" }
expect { at <0.44, 0.65> relative_radiance 550, 0.00011 within 0.00001 source "crossed: T across x T along" }
