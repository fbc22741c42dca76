// Faces that touch something: lights, polarizers and other solids behind a face, across a vanishing gap or none.
// A patch is the part of a face that touches; a path that stands in a gap is pinned to the patch it enters next.
#ifndef NICOL_CONTACTS_H
#define NICOL_CONTACTS_H
#include "path_stack.h"

// The patch under the point met, per lane, seen from inside (exits) or outside (entries): -1 for none.
FUNCTION lane_int patch_met(PRIVATE const SceneView* view, PRIVATE const Path* path, PRIVATE const Hit* hit) {
  vec3 point = along(hit->depth_mm, path->ray.direction, path->ray.position);
  lane_int patch = lane_ints(-1);
  if (any_lane(hit->key == lane_ints(KEY_EXIT))) patch = patch_under(view, path->ray.cell, point, hit->face);
  GLOBAL const int* cell = cell_of(view, path->ray.cell);
  if (has(light_contacts, view) || has(polarizer_contacts, view)) {
    for (int i = 0; i < cell[CELL_CHILD_COUNT]; ++i) {
      int child = view->lists[cell[CELL_FIRST_CHILD] + i];
      mask enters = hit->key == lane_ints(key_of_cell(child));
      if (!any_lane(enters)) continue;
      vec3 point_there = sub3(add3(point, cell_centre(view, path->ray.cell)), cell_centre(view, child));
      patch = pick(enters, patch_under(view, child, point_there, hit->face), patch);
    }
  }
  return patch;
}

// A light behind the patches met: lanes that enter a solid there end on the light.
FUNCTION void gather_covered(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE const Hit* hit,
                             lane_int patch, PRIVATE Gathered* sum) {
  mask entering = hit->key > lane_ints(KEY_EXIT);
  if (!any_lane(entering & (patch >= lane_ints(0)))) return;
  for (int i = 0; i < view->header[HEADER_PATCH_COUNT]; ++i) {
    GLOBAL const int* record = view->patches + i * PATCH_INTS;
    mask here = entering & (patch == lane_ints(i));
    if (record[PATCH_BEHIND] != BEHIND_LIGHT || !any_lane(here)) continue;
    vec3 outward = scale3(lanes(-1), broadcast(view->face_reals + record[PATCH_FACE] * FACE_REALS));
    if (record[PATCH_SHEET] >= 0) {
      outward = broadcast(view->sheet_reals + record[PATCH_SHEET] * SHEET_REALS + SHEET_PLANE);
    }
    mask seen = here & shines_towards(view, path, record[PATCH_LIGHT], outward);
    gather_light(view, path, record[PATCH_LIGHT], seen, sum);
    path->jones = keep_lanes(view, not_mask(here), path->jones);
  }
}

// Lanes of a path that just left a face into the vanishing gap before a light.
FUNCTION void gather_contact_lights(PRIVATE const SceneView* view, PRIVATE Path* path, int cell, lane_int patch,
                                    PRIVATE Gathered* sum) {
  int first = cell_of(view, cell)[CELL_FIRST_PATCH], count = cell_of(view, cell)[CELL_PATCH_COUNT];
  for (int i = first; i < first + count; ++i) {
    GLOBAL const int* record = view->patches + i * PATCH_INTS;
    mask here = patch == lane_ints(i);
    if (record[PATCH_BEHIND] != BEHIND_LIGHT || !any_lane(here)) continue;
    mask seen = here;
    if (record[PATCH_SHEET] >= 0) {
      vec3 outward = broadcast(view->sheet_reals + record[PATCH_SHEET] * SHEET_REALS + SHEET_PLANE);
      seen = here & shines_towards(view, path, record[PATCH_LIGHT], outward);
    }
    gather_light(view, path, record[PATCH_LIGHT], seen, sum);
    path->jones = keep_lanes(view, not_mask(here), path->jones);
  }
}

// Hit of a pinned path: the face of the patch's cell, at once.
FUNCTION Hit hit_across_gap(PRIVATE const SceneView* view, PRIVATE const Path* path) {
  GLOBAL const int* record = view->patches + path->pinned * PATCH_INTS;
  Hit hit;
  hit.depth_mm = lanes(0);
  hit.face = lane_ints(record[PATCH_FACE]);
  hit.normal = scale3(lanes(-1), broadcast(view->face_reals + record[PATCH_FACE] * FACE_REALS));
  hit.offset = lanes(view->face_reals[record[PATCH_FACE] * FACE_REALS + 3]);
  hit.key = lane_ints(key_of_cell(record[PATCH_CELL]));
  return hit;
}

// Keys of lanes that must part: seams, gaps, contacts and polarizers behind a face go by patch.
FUNCTION lane_int part_by_patch(PRIVATE const SceneView* view, lane_int key, lane_int patch) {
  if (!any_lane(patch >= lane_ints(0))) return key;
  for (int i = 0; i < view->header[HEADER_PATCH_COUNT]; ++i) {
    mask here = patch == lane_ints(i);
    if (view->patches[i * PATCH_INTS + PATCH_BEHIND] == BEHIND_LIGHT || !any_lane(here)) continue;
    key = pick(here, lane_ints(key_of_patch(view, i)), key);
  }
  return key;
}

// The patch of a sheet that covers the points, by which rays through the sheet enter a cell: -1 for none.
FUNCTION lane_int patch_behind_sheet(PRIVATE const SceneView* view, PRIVATE const Path* path, int sheet) {
  lane_int found = lane_ints(-1);
  for (int i = 0; i < view->header[HEADER_PATCH_COUNT]; ++i) {
    GLOBAL const int* record = view->patches + i * PATCH_INTS;
    if (record[PATCH_SHEET] != sheet) continue;
    vec3 n = broadcast(view->face_reals + record[PATCH_FACE] * FACE_REALS);
    vec3 point_there = sub3(add3(path->ray.position, cell_centre(view, path->ray.cell)), cell_centre(view, record[PATCH_CELL]));
    mask on = dot3(n, path->ray.direction) < lanes(0);
    GLOBAL const int* cell = cell_of(view, record[PATCH_CELL]);
    for (int face = cell[CELL_FIRST_FACE]; face < cell[CELL_FIRST_FACE] + cell[CELL_FACE_COUNT]; ++face) {
      GLOBAL const scalar* plane = view->face_reals + face * FACE_REALS;
      if (face != record[PATCH_FACE]) on = on & (dot3(broadcast(plane), point_there) <= lanes(plane[3]));
    }
    on = inside_patch(view, i, point_there, on);
    found = pick(on, lane_ints(i), found);
  }
  return found;
}

// Where a solid stands behind a polarizer just passed, the lanes enter that next; lanes that enter different
// solids, or none, part.
FUNCTION void enter_behind(PRIVATE const SceneView* view, PRIVATE Path* path, int sheet, PRIVATE PathStack* stack,
                           PRIVATE Gathered* sum, GLOBAL event_count* counters) {
  path->pinned = -1;
  if (!has(polarizer_contacts, view) || !view->sheets[sheet * SHEET_INTS + SHEET_TOUCHES]) return;
  lane_int behind = patch_behind_sheet(view, path, sheet);
  for (;;) {
    mask live = path_weight(view, &path->jones) > lanes(0);
    if (!any_lane(live)) return;
    int lead = largest_lane(pick(live, behind, lane_ints(-1)));
    mask mine = behind == lane_ints(lead);
    if (!any_lane(live & not_mask(mine))) {
      path->pinned = lead;
      return;
    }
    Path part = *path;
    part.jones = keep_lanes(view, mine, part.jones);
    part.pinned = lead;
    push(view, stack, part, sum, counters);
    path->jones = keep_lanes(view, not_mask(mine), path->jones);
  }
}

// What an element throws back waits; it goes on into patch `before` (-1: free).
FUNCTION void keep_reflected(PRIVATE const SceneView* view, Path back, int sheet, int before, PRIVATE PathStack* stack,
                             PRIVATE Gathered* sum, GLOBAL event_count* counters) {
  reflect_off_element(view, &back, view->sheets[sheet * SHEET_INTS + SHEET_POLARIZER]);
  back.ray.from_sheet = sheet;
  back.pinned = before;
  if (keep_bright(view, &back, sum, counters)) push(view, stack, back, sum, counters);
}

// Through a polarizer that the path stands on, and on to what touches its far side. `before`: the patch that it left.
FUNCTION void through_sheet(PRIVATE const SceneView* view, PRIVATE Path* path, int sheet, int before, PRIVATE PathStack* stack,
                            PRIVATE Gathered* sum, GLOBAL event_count* counters) {
  int polarizer = view->sheets[sheet * SHEET_INTS + SHEET_POLARIZER];
  if (reflects(view, polarizer)) keep_reflected(view, *path, sheet, before, stack, sum, counters);
  pass_polarizer(view, path, polarizer);
  path->ray.from_sheet = sheet;
  enter_behind(view, path, sheet, stack, sum, counters);
}

#endif
