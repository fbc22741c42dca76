// Where paths end: the sky, and lights seen from the outside.
#ifndef NICOL_ENDS_H
#define NICOL_ENDS_H
#include "path.h"

// Rays in the surroundings that can meet nothing but lights and sky: adds those and says so.
FUNCTION int escapes(PRIVATE const SceneView* view, PRIVATE const Path* path, PRIVATE Gathered* sum) {
  if (path->ray.cell != 0) return 0;
  GLOBAL const int* cell = cell_of(view, 0);
  mask live = path_weight(view, &path->jones) > lanes(0);
  if (has(many_solids, view)) {
    for (int i = 0; i < cell[CELL_CHILD_COUNT]; ++i) {
      int child = view->lists[cell[CELL_FIRST_CHILD] + i];
      if (child == path->ray.from_cell) continue;
      scalar radius = view->cell_reals[child * CELL_REALS + CELL_RADIUS];
      vec3 position = sub3(path->ray.position, cell_centre(view, child));
      real b = dot3(position, path->ray.direction), c = dot3(position, position) - lanes(radius * radius);
      if (any_lane(live & (b * b >= c) & ((c <= lanes(0)) | (b < lanes(0))))) return 0;
    }
  }
  mask lit = lanes(0) != lanes(0);
  lane_int met = lane_ints(-1);
  if (has(luminous_sheets, view) || has(polarizing_sheets, view)) {
    real nearest = FAR_MM;
    for (int i = 0; i < cell[CELL_SHEET_COUNT]; ++i) {
      int sheet = view->lists[cell[CELL_FIRST_SHEET] + i];
      if (sheet == path->ray.from_sheet) continue;
      vec3 normal;
      real depth = cross_sheet(view, &path->ray, sheet, &normal);
      mask nearer = depth < nearest;
      if (view->sheets[sheet * SHEET_INTS + SHEET_LIGHT] < 0 && any_lane(live & nearer)) return 0;
      nearest = pick(nearer, depth, nearest);
      met = pick(nearer, lane_ints(sheet), met);
    }
    for (int i = 0; i < cell[CELL_SHEET_COUNT]; ++i) {
      int sheet = view->lists[cell[CELL_FIRST_SHEET] + i];
      mask here = met == lane_ints(sheet);
      if (!any_lane(here)) continue;
      int light = view->sheets[sheet * SHEET_INTS + SHEET_LIGHT];
      vec3 outward = broadcast(view->sheet_reals + sheet * SHEET_REALS + SHEET_PLANE);
      gather_light(view, path, light, here & shines_towards(view, path, light, outward), sum);
      lit = lit | here;
    }
  }
  if (has(path_signatures, view)) {
    mask bright = path_weight(view, &path->jones) > SIGNATURE_WEIGHT;
    sign(view, path, bright, pick(lit, met + lane_ints(key_of_sheet(view, 0)), lane_ints(KEY_MISS)), met, lane_ints(-1), sum);
  }
  gather_sky(view, path, not_mask(lit), sum);
  return 1;
}

// Adds what the lanes see that met the sky or a light, and takes them out of the path.
FUNCTION void gather_ends(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE const Hit* hit,
                          PRIVATE Gathered* sum) {
  mask ended = hit->key == lane_ints(KEY_MISS);
  if (any_lane(ended)) gather_sky(view, path, ended, sum);
  GLOBAL const int* cell = cell_of(view, path->ray.cell);
  if (has(luminous_sheets, view)) {
    for (int i = 0; i < cell[CELL_SHEET_COUNT]; ++i) {
      int sheet = view->lists[cell[CELL_FIRST_SHEET] + i];
      int light = view->sheets[sheet * SHEET_INTS + SHEET_LIGHT];
      mask here = hit->key == lane_ints(key_of_sheet(view, sheet));
      if (light < 0 || !any_lane(here)) continue;
      vec3 outward = broadcast(view->sheet_reals + sheet * SHEET_REALS + SHEET_PLANE);
      gather_light(view, path, light, here & shines_towards(view, path, light, outward), sum);
      ended = ended | here;
    }
  }
  if (has(luminous_faces, view)) {  // seen from outside
    for (int i = 0; i < cell[CELL_CHILD_COUNT]; ++i) {
      int child = view->lists[cell[CELL_FIRST_CHILD] + i];
      mask enters = hit->key == lane_ints(key_of_cell(child));
      if (!any_lane(enters)) continue;
      int first = cell_of(view, child)[CELL_FIRST_FACE], count = cell_of(view, child)[CELL_FACE_COUNT];
      for (int face = first; face < first + count; ++face) {
        int light = view->faces[face * FACE_INTS + FACE_LIGHT];
        mask here = enters & (hit->face == lane_ints(face));
        if (light < 0 || !any_lane(here)) continue;
        gather_light(view, path, light, here, sum);
        ended = ended | here;
      }
    }
  }
  if (any_lane(ended)) path->jones = keep_lanes(view, not_mask(ended), path->jones);
}

#endif
