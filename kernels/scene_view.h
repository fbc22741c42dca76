// The packed scene as the kernels see it: pointers into the buffers of abi.h and table look-up.
#ifndef NICOL_SCENE_VIEW_H
#define NICOL_SCENE_VIEW_H
#include "abi.h"
#include "vec3.h"

typedef struct {
  int features;
  int row_offset;  // of this work-item's wavelengths inside a table row
  int stride;
  GLOBAL const int* header;
  GLOBAL const int* cells;
  GLOBAL const int* faces;
  GLOBAL const int* patches;
  GLOBAL const int* sheets;
  GLOBAL const int* lights;
  GLOBAL const int* polarizers;
  GLOBAL const int* media;
  GLOBAL const int* lists;
  GLOBAL const int* fragments;
  GLOBAL const scalar* camera;
  GLOBAL const scalar* cell_reals;
  GLOBAL const scalar* face_reals;
  GLOBAL const scalar* patch_reals;
  GLOBAL const scalar* edges;
  GLOBAL const scalar* sheet_reals;
  GLOBAL const scalar* polarizer_reals;
  GLOBAL const scalar* fragment_reals;
  GLOBAL const scalar* tables;
  scalar adc_bailout;
  scalar conical_spread;            // half the angle of the bundle that one ray stands for
  real conical_cos, conical_sin;    // azimuth on the cone that this sample takes
  int max_trace_level;
} SceneView;

FUNCTION SceneView view_scene(GLOBAL const int* ints, GLOBAL const scalar* reals,
                              GLOBAL const scalar* tables, int row_offset) {
  SceneView v;
  v.features = ints[HEADER_FEATURES];
  v.row_offset = row_offset;
  v.stride = ints[HEADER_LAMBDA_STRIDE];
  v.header = ints;
  v.cells = ints + ints[HEADER_CELLS_AT];
  v.faces = ints + ints[HEADER_FACES_AT];
  v.patches = ints + ints[HEADER_PATCHES_AT];
  v.sheets = ints + ints[HEADER_SHEETS_AT];
  v.lights = ints + ints[HEADER_LIGHTS_AT];
  v.polarizers = ints + ints[HEADER_POLARIZERS_AT];
  v.media = ints + ints[HEADER_MEDIA_AT];
  v.lists = ints + ints[HEADER_LISTS_AT];
  v.fragments = ints + ints[HEADER_FRAGMENTS_AT];
  v.camera = reals + ints[HEADER_CAMERA_REALS];
  v.cell_reals = reals + ints[HEADER_CELL_REALS];
  v.face_reals = reals + ints[HEADER_FACE_REALS];
  v.patch_reals = reals + ints[HEADER_PATCH_REALS];
  v.edges = reals + ints[HEADER_EDGE_REALS];
  v.sheet_reals = reals + ints[HEADER_SHEET_REALS];
  v.polarizer_reals = reals + ints[HEADER_POLARIZER_REALS];
  v.fragment_reals = reals + ints[HEADER_FRAGMENT_REALS];
  v.tables = tables;
  v.adc_bailout = reals[ints[HEADER_SETTING_REALS] + SETTING_ADC_BAILOUT];
  v.conical_spread = reals[ints[HEADER_SETTING_REALS] + SETTING_CONICAL_SPREAD];
  v.conical_cos = lanes(1);
  v.conical_sin = lanes(0);
  v.max_trace_level = ints[HEADER_MAX_TRACE_LEVEL];
  return v;
}

// A row of the tables at this work-item's wavelengths.
FUNCTION real spectral(PRIVATE const SceneView* view, int row) {
  GLOBAL const scalar* p = view->tables + row * view->stride + view->row_offset;
  return has(lanes_over_pixels, view) ? lanes(*p) : load_lanes(p);
}

FUNCTION GLOBAL const int* cell_of(PRIVATE const SceneView* view, int cell) {
  return view->cells + cell * CELL_INTS;
}
FUNCTION vec3 cell_centre(PRIVATE const SceneView* view, int cell) {
  return broadcast(view->cell_reals + cell * CELL_REALS + CELL_CENTRE);
}
FUNCTION int medium_row(PRIVATE const SceneView* view, int medium, int which) {
  return view->media[medium * MEDIUM_INTS + MEDIUM_ROW] + which;
}

#endif
