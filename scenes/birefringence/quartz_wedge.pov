// A wedge of quartz between crossed polarizers, its optic axis at 45 deg to them, in daylight: the colours of
// Newton and Michel-Levy, from black at the thin edge to the fourth order. The plates below retard by 150, 300,
// 550, 1000 and 1700 nm; the wavelengths are close enough that the two waves stay coherent. Look for: first-order
// grey, white, yellow, red; the sensitive tint (551 nm) and its sharp change to blue; paler pinks and greens
// further on.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 380 to 780 step 10 }
  max_trace_level 20  adc_bailout 1e-6  exposure 1.8 }

#declare Longest = 0.24;      // mm: 2184 nm at 589 nm
#declare View = 20;           // mm
camera { orthographic  location -50*z  look_at 0  right View*x  up View*y  polarizer { ideal axis y } }
polygon { 5, <-10, -10, 1>, <10, -10, 1>, <10, 10, 1>, <-10, 10, 1>, <-10, -10, 1>
  luminous { spectrum { d65 } polarizer { ideal axis x } } }

// The wedge: its lower face is flat, its upper face rises to the right.
prism { 0.5, 9, 4, <-9.5, 0>, <9.5, 0>, <9.5, -Longest>, <-9.5, 0>
  interior { M_Quartz_Inactive optic_axis <1, 1, 0> } }

// Five steps below: retardation in nm at 589.3 nm.
#declare Dn = Quartz_E(589.3) - Quartz_O(589.3);
#declare Step_nm = array[5] { 150, 300, 550, 1000, 1700 }
#for (I, 0, 4)
  box { <-9.5 + 3.9*I, -9, -Step_nm[I]*nm/Dn>, <-9.5 + 3.9*I + 3.4, -0.5, 0>  interior { M_Quartz_Inactive optic_axis <1, 1, 0> } }
#end

// ---- what it must give ----------------------------------------------------------------------------
// A plate at normal incidence: of the light (half of it passes the first polarizer) |a_o - a_e|^2/4 passes the
// second, a_o = T_o rho^m of order m, with T = 1 - R, rho_o = R_o, each order with 2m + 1 times the retardation d:
// sum over m of |T_o R_o^m - T_e R_e^m exp(i (2m + 1) d)|^2/4 (Born & Wolf 15.4.2).
#macro Step_Radiance(Lambda, Retardation_589)
  #local R_O = Normal_R(1, Quartz_O(Lambda));
  #local R_E = Normal_R(1, Quartz_E(Lambda));
  #local Thickness = Retardation_589*nm/Dn;
  #local Phase = 2*pi*(Quartz_E(Lambda) - Quartz_O(Lambda))*Thickness/(Lambda*nm);
  #local Sum = 0;
  #for (M, 0, 3)
    #local A = (1 - R_O)*pow(R_O, M);
    #local B = (1 - R_E)*pow(R_E, M);
    #local Sum = Sum + (A*A + B*B - 2*A*B*cos((2*M + 1)*Phase))/4;
  #end
  (Sum/2)
#end
#for (I, 0, 4)
  #for (Lambda, 420, 700, 140)
    expect {
      relative_radiance Lambda, Step_Radiance(Lambda, Step_nm[I])
      at <0.5 + (-9.5 + 3.9*I + 1.7)/View, 0.74> within 1e-5
      source "crossed polarizers, Born & Wolf 15.4.2, indices of Ghosh 1999, Fresnel at both faces, all orders"
    }
  #end
#end

// The published colours: the same sum over daylight for 1 nm, without the faces; these take (1 - R)^2 = 0.914 and the
// first polarizer half of the light.
#declare Seen = pow(1 - Normal_R(1, 1.549), 2)/2;
#macro Expect_Colour(I, Xyz)
  expect {
    xyz Seen*Xyz at <0.5 + (-9.5 + 3.9*I + 1.7)/View, 0.74> within 0.003
    source "Michel-Levy's colours by Ghosh's dispersion, CIE 1931, D65, integrated at 1 nm"
  }
#end
Expect_Colour(0, <0.53328, 0.57031, 0.83395>)
Expect_Colour(1, <0.88518, 0.96100, 0.76882>)
Expect_Colour(2, <0.15804, 0.06297, 0.53553>)
Expect_Colour(3, <0.61934, 0.38358, 0.59080>)
Expect_Colour(4, <0.30323, 0.35425, 0.40269>)
