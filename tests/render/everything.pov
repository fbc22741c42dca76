// One of each thing that a scene can call for, so that every feature has something to do.
#version unofficial 3.7;
global_settings { mm_per_unit 1 max_trace_level 12 adc_bailout 1e-4 conical_rays 3 conical_spread 2 sample_error 0.5 wavelengths { from 460 to 640 step 30 } }
#declare Glass = interior { index { cauchy 1.5046, 0.0042 } }
#declare Active = interior { index { constant 1.6 } rotation { biot 7.2 } }
#declare Smoke = interior { index { constant 1.45 } absorption { constant 0.05 } }

// crystals: ordinary and extraordinary waves that absorb, a biaxial one, an active one
#declare Dichroic = interior { ordinary { constant 1.64 } extraordinary { constant 1.62 } optic_axis <1, 2, 0.5>
  absorption { ordinary { constant 0.3 } extraordinary { constant 0.05 } } }
#declare Biaxial = interior { alpha { constant 1.53 } beta { constant 1.681 } gamma { constant 1.6855 } }
#declare Quartz = interior { ordinary { constant 1.5443 } extraordinary { constant 1.5534 } rotation { constant 21.7 } gyration { ratio -0.449 } }

camera { location <6, 9, -38> right x angle 38 look_at <0, 3, 0> polarizer { ideal angle 20 } }
background { spectrum { d65 scale 0.4 } }

// a light with a polarizer, a cube on it that holds a smaller one
polygon { 5, <-7, 0, -7>, <7, 0, -7>, <7, 0, 7>, <-7, 0, 7>, <-7, 0, -7>
  luminous { spectrum { a } polarizer { calcite angle 70 } } }
box { <-3, 0, -3>, <3, 6, 3> interior { Active } }
box { -1, 1 rotate 30*y translate <0.3, 3, 0.2> interior { Smoke } }
// across a gap, in optical contact, and a concave one
box { <3, 0, -2>, <5, 4, 2> interior { Glass } }
box { <5, 0, -2>, <6, 3, 2> interior { Active } optical_contact on }
prism { 0, 3, 7, <-9, -4>, <-5, -4>, <-5, 2>, <-7, 2>, <-7, -2>, <-9, -2>, <-9, -4> interior { Glass } translate 1*y }
// shining: a ring, one face of a box
disc { <-2, 9, 2>, <0.2, -1, -0.1>, 2, 0.7 luminous { spectrum { e scale 2 } one_sided on } }
box { <8, 1, -3>, <10, 3, -1> interior { Glass } luminous { spectrum { d65 } face y } }
// crystals: one over another in contact, a thin plate whose waves add as amplitudes, one inside glass
box { <-6, 5, -7>, <-4, 7, -5> interior { Dichroic } }
box { <-6, 7, -7>, <-4, 8, -5> interior { Biaxial } optical_contact on }
box { <-1, -1, -0.02>, <1, 1, 0.02> interior { Quartz } rotate 20*y translate <5, 7, -9> }
box { <9, 4, -3>, <12, 7, 0> interior { Glass } }
box { <10, 5, -2>, <11, 6, -1> interior { Biaxial } rotate <0, 0, 0> }
// polarizing: free, and in front of a face
disc { <-1, 4, -12>, z, 3 polarizer { ideal angle 65 } }
box { <1, 7, -2>, <4, 9, 1> interior { Glass } }
polygon { 5, <1, 7, -2>, <4, 7, -2>, <4, 9, -2>, <1, 9, -2>, <1, 7, -2> polarizer { ideal angle 30 projection absorption } }
// a plugin's element and a plugin's surface
disc { <3, 2, -14>, <0.2, 0.1, -1>, 2 polarizer { plugin { "../fragments/plugins/ideal_element" } angle 15 } }
box { <-9, 6, -2>, <-7, 8, 0> interior { Glass } surface { plugin { "../fragments/plugins/bare_face" } } }
