/* A glass cube on a light, for both programs. The include file is nicol's own. */
static const char scene_text[] =
    "#version unofficial 3.7;\n"
    "#declare Mm_Per_Unit = 1;\n"
    "#include \"units.inc\"\n"
    "global_settings { mm_per_unit Mm_Per_Unit wavelengths { 450, 550, 650 } max_trace_level 12 adc_bailout 1e-4 }\n"
    "camera { location <0, 30, -30> right x*image_width/image_height angle 30 look_at 0 }\n"
    "background { spectrum { e scale 0.4 } }\n"
    "polygon { 5, <-8, 0, -8>, <8, 0, -8>, <8, 0, 8>, <-8, 0, 8>, <-8, 0, -8> luminous { spectrum { e } } }\n"
    "box { <-4, 0, -4>, <4, 6*mm, 4> interior { ior 1.5 } }\n";
