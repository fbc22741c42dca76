// The cleavage rhomb of calcite on a printed page, seen from straight above: Bartholin's "disdiaclasticum" of
// 1669. All faces are {10-14}; the optic axis stands at 44.6 deg to each of them. One image stays, the other one
// stands aside along the short diagonal of the face; turn the rhomb and it goes round the first. Look for: two
// texts of half the blackness each, black only where both overlap; the page about the rhomb shows what is written.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "units.inc"
#include "minerals.inc"
#include "closed_forms.inc"
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 50 }
  max_trace_level 12  adc_bailout 2e-4 }

#declare Height = 24;         // mm, between the rhomb's faces
#declare Ink = 0.04;          // of the paper's radiance
#declare Sky = 0.3;
#declare View = 58;           // mm
camera { orthographic  location 60*y  sky z  right View*x  up View*y  look_at 0 }
background { spectrum { d65 scale Sky } }
polygon { 5, <-60, 0, -60>, <60, 0, -60>, <60, 0, 60>, <-60, 0, 60>, <-60, 0, -60>
  translate -0.02*y  luminous { spectrum { d65 } } }

// Letters of bars, 5 wide and 7 high, in lines; ink lies on the paper.
#macro Bar(X, Z, Width, Depth)
  polygon { 5, <X, 0, Z>, <X + Width, 0, Z>, <X + Width, 0, Z + Depth>, <X, 0, Z + Depth>, <X, 0, Z>
    translate -0.01*y  luminous { spectrum { d65 scale Ink } } }
#end
#macro Letter_L(X, Z) Bar(X, Z, 1, 7) Bar(X + 1, Z, 3, 1) #end
#macro Letter_I(X, Z) Bar(X + 1.5, Z, 1, 7) #end
#macro Letter_T(X, Z) Bar(X + 1.5, Z, 1, 6) Bar(X, Z + 6, 4, 1) #end
#macro Letter_E(X, Z) Bar(X, Z, 1, 7) Bar(X + 1, Z, 3, 1) Bar(X + 1, Z + 3, 2.4, 1) Bar(X + 1, Z + 6, 3, 1) #end
#macro Letter_C(X, Z) Bar(X, Z, 1, 7) Bar(X + 1, Z, 3, 1) Bar(X + 1, Z + 6, 3, 1) #end
#macro Letter_A(X, Z) Bar(X, Z, 1, 7) Bar(X + 3, Z, 1, 7) Bar(X + 1, Z + 6, 2, 1) Bar(X + 1, Z + 3, 2, 1) #end
#macro Word(Z, Shift)
  Letter_C(Shift - 21, Z) Letter_A(Shift - 15, Z) Letter_L(Shift - 9, Z) Letter_C(Shift - 3, Z)
  Letter_I(Shift + 2, Z) Letter_T(Shift + 6, Z) Letter_E(Shift + 12, Z)
#end
#for (Row, -3, 2)
  Word(12*Row + 2.5, 3)
#end

// Laid with one face on the page: its normal, 44.63 deg from c in the plane of c and the viewer, turned up; then
// turned about the vertical, so that the images part aslant.
#declare Axial_Ratio = 17.061/4.990;      // Effenberger, Mereiter & Zemann, Z. Krist. 156, 233 (1981)
#declare Slant = degrees(atan2(2/sqrt(3)*Axial_Ratio, 4));
#declare Turn = 25;           // deg
crystal {
  cell { 4.990, 4.990, 17.061 }  point_group "-3m"
  form { 1, 0, -1, 4, Height/2 }
  interior { M_Calcite }
  rotate 30*y rotate Slant*x
  rotate Turn*y
  translate Height/2*y
}

// ---- what it must give ----------------------------------------------------------------------------
// At normal incidence on the top: each wave sees the page through all orders between top and bottom, and the sky
// by what they reflect; the extraordinary one sees it Aside further towards the side to which the axis leans.
#declare N_O = Calcite_O(550);
#declare N_E = Calcite_E(550);
#declare Aside = Height*Tan_Walk_Off(N_O, N_E, Slant)*<sin(radians(Turn)), cos(radians(Turn))>;
#declare T_O = Plate_T(N_O);
#declare T_E = Plate_T(Extraordinary_N(N_O, N_E, Slant));
#macro Expect_At(Place, Page_O, Page_E, Why)
  #local O = (T_O*Page_O + (1 - T_O)*Sky)/2;
  #local E = (T_E*Page_E + (1 - T_E)*Sky)/2;
  #local Azimuth = radians(90 - Turn);    // of the principal section
  expect {
    stokes 550, <O + E, (E - O)*cos(2*Azimuth), (E - O)*sin(2*Azimuth), 0>
    at <0.5 + Place.u/View, 0.5 - Place.v/View> within 1e-4
    source concat(Why, ": walk-off and Fresnel by Ghosh 1999's indices")
  }
#end
#declare On_Letter = <7, 4>;    // on the bar of the I
Expect_At(On_Letter, Ink, 1, "ordinary wave on ink, extraordinary on paper")
Expect_At(On_Letter - Aside, 1, Ink, "ordinary on paper, extraordinary on ink")
Expect_At(<3, 0>, 1, 1, "both on paper")
#declare Hair = <0.495, 0>;     // half a bar, but for 5 um
#declare Clear = <0.505, 0>;
Expect_At(On_Letter - Aside + Hair, 1, Ink, "just inside the extraordinary bar")
Expect_At(On_Letter - Aside + Clear, 1, 1, "just outside the extraordinary bar")
Expect_At(On_Letter - Aside - Hair, 1, Ink, "just inside its other edge")
Expect_At(On_Letter - Aside - Clear, 1, 1, "just outside its other edge")
expect { relative_radiance 550, 1 at <0.05, 0.5> within 1e-6 source "paper" }
