// The tree of reflected and refracted rays behind one sample of a pixel, followed to its end.
//
// Of two children the lighter is followed and the heavier kept for later: each step down then at least
// halves the weight, so the stack never holds more than log2(lanes / adc_bailout) paths. Rays that leave towards
// the lights without meeting another solid are added at once and never kept.
// Lanes go together as long as they meet the same kind of thing; which face they meet is each lane's own
// matter. Lanes that part company are kept as a path of their own.
#ifndef NICOL_TRACE_H
#define NICOL_TRACE_H
#include "interface.h"

#ifndef STACK_SIZE
#define STACK_SIZE 40
#endif

typedef struct {
  Path paths[STACK_SIZE];
  int size;
} PathStack;

FUNCTION void push(PRIVATE const SceneView* view, PRIVATE PathStack* stack, Path path, PRIVATE Gathered* sum,
                   GLOBAL event_count* counters) {
  if (stack->size < STACK_SIZE) {
    stack->paths[stack->size++] = path;
    return;
  }
  count_event(counters, COUNT_STACK);
  sum->cut_off += path_weight(view, &path.jones);
}

// Moves a path from its cell into another one's coordinates.
FUNCTION void change_cell(PRIVATE const SceneView* view, PRIVATE Path* path, int cell) {
  vec3 shift = sub3(cell_centre(view, path->ray.cell), cell_centre(view, cell));
  path->ray.position = add3(path->ray.position, shift);
  path->ray.cell = cell;
}

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
  if (has(luminous_sheets, view) || has(polarizing_sheets, view)) {
    real nearest = FAR_MM;
    lane_int met = lane_ints(-1);
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
    on = inside_edges(view, record[PATCH_FIRST_EDGE], record[PATCH_EDGE_COUNT], point_there, on);
    if (has(discs, view) && record[PATCH_HAS_DISC]) {
      GLOBAL const scalar* reals = view->patch_reals + i * PATCH_REALS;
      on = on & inside_ring(point_there, broadcast(reals + PATCH_DISC_CENTRE), reals[PATCH_RADIUS2], reals[PATCH_HOLE2]);
    }
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
    int lead = first_lane(live, behind);
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

// Through a polarizer that the path stands on, and on to what touches its far side.
FUNCTION void through_sheet(PRIVATE const SceneView* view, PRIVATE Path* path, int sheet, PRIVATE PathStack* stack,
                            PRIVATE Gathered* sum, GLOBAL event_count* counters) {
  pass_polarizer(view, path, view->sheets[sheet * SHEET_INTS + SHEET_POLARIZER]);
  path->ray.from_sheet = sheet;
  enter_behind(view, path, sheet, stack, sum, counters);
}

// Follows the tree behind `path` and adds what it brings. Returns the lane-segments traced.
FUNCTION int follow(PRIVATE const SceneView* view, Path path, PRIVATE PathStack* stack, PRIVATE Gathered* sum,
                    GLOBAL event_count* counters) {
  int segments = 0;
  stack->size = 0;
  for (;;) {
    mask live = path_weight(view, &path.jones) > lanes(0);
    segments += count_lanes(live);
    Hit hit = path.pinned >= 0 ? hit_across_gap(view, &path) : next_hit(view, &path.ray);
    gather_ends(view, &path, &hit, sum);
    int contacts = has(light_contacts, view) || has(polarizer_contacts, view) || has(solid_contacts, view);
    lane_int patch = lane_ints(-1);
    if (contacts && path.pinned < 0) {
      patch = patch_met(view, &path, &hit);
      if (has(light_contacts, view)) gather_covered(view, &path, &hit, patch, sum);
      if (has(polarizer_contacts, view) || has(solid_contacts, view))
        hit.key = part_by_patch(view, hit.key, patch);
    }
    live = path_weight(view, &path.jones) > lanes(0);
    int going = any_lane(live);
    if (going) {
      // lanes that meet something else than the first live lane wait for their turn
      int lead = first_lane(live, hit.key);
      mask others = live & (hit.key != lane_ints(lead));
      if (any_lane(others)) {
        Path waiting = path;
        waiting.jones = keep_lanes(view, others, path.jones);
        push(view, stack, waiting, sum, counters);
        path.jones = keep_lanes(view, not_mask(others), path.jones);
      }
      // what is met: a sheet, a patch or a face
      int first_sheet = key_of_sheet(view, 0), first_patch = key_of_patch(view, 0);
      int met_patch = lead >= first_patch ? lead - first_patch : -1;
      int cell = path.ray.cell, behind = -1, target;
      if (met_patch >= 0) behind = view->patches[met_patch * PATCH_INTS + PATCH_BEHIND];
      // turn the dead lanes' hits into something finite
      hit.depth_mm = pick(hit.depth_mm < FAR_MM, hit.depth_mm, lanes(0));
      path.ray.direction = pick3(dot3(path.ray.direction, hit.normal) > lanes(0), path.ray.direction, hit.normal);
      path.ray.position = along(hit.depth_mm, path.ray.direction, path.ray.position);
      int medium1 = cell_of(view, cell)[CELL_MEDIUM];
      vec3 u = has(polarization, view) ? across_incidence(hit.normal, path.ray.direction) : path.axis;
      go_through(view, &path, medium1, hit.depth_mm, u);
      if ((has(polarizing_sheets, view)) && lead >= first_sheet && lead < first_patch) {
        ++path.level;
        path.ray.from_cell = -1;
        through_sheet(view, &path, lead - first_sheet, stack, sum, counters);
        going = keep_bright(view, &path, sum, counters);
      } else if (has(solid_contacts, view) && behind == BEHIND_SEAM) {
        change_cell(view, &path, view->patches[view->patches[met_patch * PATCH_INTS + PATCH_TWIN] * PATCH_INTS + PATCH_CELL]);
        path.pinned = -1;
      } else if (has(polarizer_contacts, view) && behind == BEHIND_POLARIZER &&
                 view->patches[met_patch * PATCH_INTS + PATCH_CELL] != cell) {
        // a covered face met from outside: through the polarizer, then the face
        path.pinned = met_patch;
        pass_polarizer(view, &path, view->sheets[view->patches[met_patch * PATCH_INTS + PATCH_SHEET] * SHEET_INTS + SHEET_POLARIZER]);
        ++path.level;
        going = keep_bright(view, &path, sum, counters);
      } else {
        int exits = lead == KEY_EXIT || met_patch >= 0;
        int twin = met_patch >= 0 ? view->patches[met_patch * PATCH_INTS + PATCH_TWIN] : -1;
        if (exits) {
          target = behind == BEHIND_CELL_CONTACT ? view->patches[twin * PATCH_INTS + PATCH_CELL]
                                                 : cell_of(view, cell)[CELL_PARENT];
        } else {
          target = lead - KEY_FIRST_CELL;
        }
        Interface face;
        face.normal = hit.normal;
        face.medium1 = medium1;
        face.medium2 = cell_of(view, target)[CELL_MEDIUM];
        int pinned = path.pinned;
        path.pinned = -1;
        Path refracted = split(view, &path, face, sum);
        change_cell(view, &refracted, target);
        refracted.ray.from_cell = exits ? cell : -1;
        refracted.ray.from_sheet = -1;
        path.ray.from_cell = exits ? -1 : target;
        path.ray.from_sheet = -1;
        if (exits && has(light_contacts, view)) gather_contact_lights(view, &refracted, cell, patch, sum);
        if (exits && has(polarizer_contacts, view) && behind == BEHIND_POLARIZER) {
          through_sheet(view, &refracted, view->patches[met_patch * PATCH_INTS + PATCH_SHEET], stack, sum, counters);
        }
        if (exits && has(solid_contacts, view) && behind == BEHIND_CELL_GAP) refracted.pinned = twin;
        if (!exits && pinned >= 0) {  // thrown back by the face beyond the gap
          GLOBAL const int* record = view->patches + pinned * PATCH_INTS;
          if (has(solid_contacts, view) && record[PATCH_BEHIND] == BEHIND_CELL_GAP) path.pinned = record[PATCH_TWIN];
          if (has(polarizer_contacts, view) && record[PATCH_BEHIND] == BEHIND_POLARIZER)
            through_sheet(view, &path, record[PATCH_SHEET], stack, sum, counters);
        }
        // what leaves for good is added whatever its weight; adc_bailout cuts what would go on
        int through = is_live(view, &refracted) && !(refracted.pinned < 0 && escapes(view, &refracted, sum)) &&
                      keep_bright(view, &refracted, sum, counters);
        int back = is_live(view, &path) && !(path.pinned < 0 && escapes(view, &path, sum)) &&
                   keep_bright(view, &path, sum, counters);
        if (through && back) {
          scalar w_through = sum_lanes(path_weight(view, &refracted.jones));
          scalar w_back = sum_lanes(path_weight(view, &path.jones));
          push(view, stack, w_through > w_back ? refracted : path, sum, counters);
          if (!(w_through > w_back)) path = refracted;
        } else if (through) {
          path = refracted;
        }
        going = through || back;
      }
    }
    if (!going) {
      if (stack->size == 0) return segments;
      path = stack->paths[--stack->size];
    }
  }
}

#endif
