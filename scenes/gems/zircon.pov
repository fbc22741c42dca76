// A brilliant of zircon, its optic axis in the girdle plane along x, face up. The stone is strongly birefringent
// (0.059): its back facets are seen twice, and the two images are polarized across each other. A jeweller tells
// zircon from diamond by this. Look for: doubled edges on the left and right of the table, single ones above and
// below, and lamps in pairs.
#version unofficial 3.7;
#declare Mm_Per_Unit = 1;
#include "minerals.inc"
#include "cuts.inc"
#declare Diameter = 8;        // mm
#declare View = 8.8;          // mm
#declare Dim = 0.06;
global_settings { mm_per_unit Mm_Per_Unit  wavelengths { from 400 to 700 step 50 }
  max_trace_level 14  adc_bailout 5e-3  exposure 2 }
#include "face_up.inc"
#declare Pavilion = 41;       // deg
object { Standard_Brilliant(Diameter, 0.55, 35, Pavilion)  interior { M_Zircon optic_axis x } }

// ---- what it must give ----------------------------------------------------------------------------
#declare N_O = 1.925; #declare N_E = 1.984;      // Handbook of Mineralogy
#declare R = Diameter/2;
// Ordinary: across the plane of x and y, as in glass. Extraordinary: in it; k from facet to facet by its
// tangential component.
#declare Out_O = N_O*sin(radians(4*Pavilion));
#declare C = cos(radians(Pavilion));
#declare S = sin(radians(Pavilion));
#declare Q_1 = N_E*S;                            // k = (0, -n_e) on the left facet's tangent
#declare P_1 = P_Normal_Component(N_E*N_E, N_O*N_O, Q_1, Pavilion, 1);
#declare K_1 = <Q_1*C + P_1*S, -Q_1*S + P_1*C, 0>;
#declare Q_2 = K_1.x*C + K_1.y*S;                // on the right facet's
#declare P_2 = P_Normal_Component(N_E*N_E, N_O*N_O, Q_2, -Pavilion, 1);
#declare Out_E = Q_2*C - P_2*S;
#for (Eighth, 0, 7)
  #if (Eighth != 4) Lamp(Out_O, 45*Eighth, 12) #end
  #for (Ring, 1, 5)
    Lamp(0.17*Ring, 45*Eighth + 22.5, 50)
  #end
#end
Lamp(Out_E, 180, 12)
#declare T_O = (1 - Normal_R(1, N_O))*S_Face_T(N_O, 1, sin(radians(4*Pavilion)));
#declare T_E = (1 - Normal_R(1, N_E))*P_Face_T(N_E*N_E, N_O*N_O, 1, 1, Out_E, 0);
#debug concat("leaves at ", str(degrees(asin(Out_O)), 0, 3), " and ", str(degrees(asin(Out_E)), 0, 3), " deg\n")
expect {
  stokes 550, <Dim + (1 - Dim)*T_O/2, -(1 - Dim)*T_O/2, 0, 0> at <0.5 - 0.1*R/View, 0.5> within 5e-3
  source "the lamp at the right is met by the ordinary wave alone: Snell, Fresnel"
}
expect {
  stokes 550, <Dim + (1 - Dim)*T_E/2, (1 - Dim)*T_E/2, 0, 0> at <0.5 + 0.1*R/View, 0.5> within 5e-3
  source "the lamp at the left is met by the extraordinary wave alone: k by its tangential components, impedances"
}
