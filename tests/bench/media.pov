// One cube of a crystal of each class before a sky, to compare what their waves cost. Kind: 0 glass, 1 uniaxial, 2 biaxial, 3 active
// uniaxial, 4 uniaxial that absorbs; coherence by Coherent.
#version unofficial 3.7;
#ifndef (Kind) #declare Kind = 0; #end
#ifndef (Coherent) #declare Coherent = on; #end
global_settings { mm_per_unit 1 max_trace_level 10 adc_bailout 0.002 coherence Coherent wavelengths { from 400 to 700 step 20 } }
camera { location <20, 24, -60> right x angle 24 look_at 0 }
background { spectrum { e } }
box { -8, 8
  #switch (Kind)
    #case (0) interior { index { cauchy 1.6, 0.004 } } #break
    #case (1) interior { ordinary { cauchy 1.65, 0.004 } extraordinary { cauchy 1.55, 0.004 } optic_axis <1, 2, 0.7> } #break
    #case (2) interior { alpha { cauchy 1.53, 0.004 } beta { cauchy 1.6, 0.004 } gamma { cauchy 1.68, 0.004 } } rotate <20, 30, 0> #break
    #case (3) interior { ordinary { cauchy 1.544, 0.004 } extraordinary { cauchy 1.553, 0.004 } rotation { biot 7.2 }
                         gyration { ratio -0.449 } optic_axis <1, 2, 0.7> } #break
    #case (4) interior { ordinary { cauchy 1.65, 0.004 } extraordinary { cauchy 1.55, 0.004 } optic_axis <1, 2, 0.7>
                         absorption { ordinary { constant 0.05 } extraordinary { constant 0.01 } } } #break
  #end
}
