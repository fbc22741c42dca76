// The tree of reflected and refracted rays behind one sample of a pixel, followed to its end.
//
// Of the children the lightest is followed and the heavier ones kept for later, the heaviest deepest: with m children the
// path followed has at most 1/m of the weight, so the stack never holds more than log2(lanes / adc_bailout) paths where
// faces send two, and (m - 1)/log2 m times that where crystals send m. Rays that leave towards
// the lights without meeting another solid are added at once and never kept.
// Lanes go together as long as they meet the same kind of thing; which face they meet is each lane's own
// matter. Lanes that part company are kept as a path of their own.
#ifndef NICOL_TRACE_H
#define NICOL_TRACE_H
#include "contacts.h"
#include "crystal_face.h"
#include "ends.h"
#include "interface.h"

// What the lanes that go together meet.
typedef struct {
  Hit hit;
  lane_int patch;   // under the point met, per lane; -1: none
  int lead;         // key of all live lanes
  int met_patch;    // the patch that they meet, -1: none
  int behind;       // what lies behind it, -1
} Event;

// The next event of a path: adds what ends, and keeps the lanes back that meet something else.
// False if no lane is left.
FUNCTION int next_event(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE PathStack* stack,
                        PRIVATE Gathered* sum, GLOBAL event_count* counters, PRIVATE Event* event) {
  WITNESS(goes_through(path->ray.cell, path->carries == CARRIES_PAIR, path_weight(view, &path->jones)));
  Hit hit = path->pinned >= 0 ? hit_across_gap(view, path) : next_hit(view, &path->ray);
  event->patch = lane_ints(-1);
  int contacts = has(light_contacts, view) || has(polarizer_contacts, view) || has(solid_contacts, view);
  if (contacts && path->pinned < 0) event->patch = patch_met(view, path, &hit);
  lane_int met = hit.key;
  mask bright = lanes(0) != lanes(0);
  if (has(path_signatures, view)) bright = path_weight(view, &path->jones) > SIGNATURE_WEIGHT;
  gather_ends(view, path, &hit, sum);
  if (contacts && path->pinned < 0) {
    if (has(light_contacts, view)) gather_covered(view, path, &hit, event->patch, sum);
    if (has(polarizer_contacts, view) || has(solid_contacts, view))
      hit.key = part_by_patch(view, hit.key, event->patch);
  }
  mask live = path_weight(view, &path->jones) > lanes(0);
  event->lead = largest_lane(pick(live, hit.key, lane_ints(KEY_MISS)));
  mask others = live & (hit.key != lane_ints(event->lead));
  if (has(path_signatures, view)) sign(view, path, bright & not_mask(others), met, hit.face, event->patch, sum);
  if (!any_lane(live)) return 0;
  if (any_lane(others)) {
    Path waiting = *path;
    waiting.jones = keep_lanes(view, others, path->jones);
    push(view, stack, waiting, sum, counters);
    path->jones = keep_lanes(view, not_mask(others), path->jones);
  }
  int first_patch = key_of_patch(view, 0);
  event->met_patch = event->lead >= first_patch ? event->lead - first_patch : -1;
  event->behind = event->met_patch >= 0 ? view->patches[event->met_patch * PATCH_INTS + PATCH_BEHIND] : -1;
  event->hit = hit;
  return 1;
}

// Moves the path to what it meets, through the medium of its cell; its axes turn to the plane of incidence.
FUNCTION void go_to(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE Event* event) {
  PRIVATE Hit* hit = &event->hit;
  // the hits of dead lanes are turned into something finite
  hit->depth_mm = pick(hit->depth_mm < FAR_MM, hit->depth_mm, lanes(0));
  path->ray.direction = pick3(dot3(path->ray.direction, hit->normal) > lanes(0), path->ray.direction, hit->normal);
  path->ray.position = along(hit->depth_mm, path->ray.direction, path->ray.position);
  if (is_crystal(view, cell_of(view, path->ray.cell)[CELL_MEDIUM])) {
    go_through_crystal(view, path, cell_of(view, path->ray.cell)[CELL_MEDIUM], hit->depth_mm);
    return;
  }
  vec3 u = has(polarization, view) ? across_incidence(hit->normal, path->ray.direction) : path->axis;
  go_through(view, path, cell_of(view, path->ray.cell)[CELL_MEDIUM], hit->depth_mm, u);
}

// Takes out what rounding has left between the path and the face that it stands on, in coordinates of the face's cell: after a
// long way the next one would be off by that much. `turn`: 1 if the normal is the face's own, -1 if it is turned.
FUNCTION void put_on_face(PRIVATE Path* path, PRIVATE const Hit* hit, real turn) {
  real left = turn * hit->offset - dot3(hit->normal, path->ray.position);
  path->ray.position = along(left, hit->normal, path->ray.position);
}

// The cell beyond the face that the path meets.
FUNCTION int cell_beyond(PRIVATE const SceneView* view, PRIVATE const Path* path, PRIVATE const Event* event) {
  if (event->behind == BEHIND_CELL_CONTACT) {
    int twin = view->patches[event->met_patch * PATCH_INTS + PATCH_TWIN];
    return view->patches[twin * PATCH_INTS + PATCH_CELL];
  }
  if (event->lead == KEY_EXIT || event->met_patch >= 0) return cell_of(view, path->ray.cell)[CELL_PARENT];
  return event->lead - KEY_FIRST_CELL;
}

// What a path that left a face meets in the gap behind it.
FUNCTION void meet_behind(PRIVATE const SceneView* view, PRIVATE Path* through, PRIVATE const Event* event, int cell,
                          PRIVATE PathStack* stack, PRIVATE Gathered* sum, GLOBAL event_count* counters) {
  if (has(light_contacts, view)) gather_contact_lights(view, through, cell, event->patch, sum);
  if (has(polarizer_contacts, view) && event->behind == BEHIND_POLARIZER)
    through_sheet(view, through, view->patches[event->met_patch * PATCH_INTS + PATCH_SHEET], event->met_patch, stack, sum,
                  counters);
  if (has(solid_contacts, view) && event->behind == BEHIND_CELL_GAP)
    through->pinned = view->patches[event->met_patch * PATCH_INTS + PATCH_TWIN];
}

// What a path meets that a face has thrown back into the gap before it.
FUNCTION void meet_before(PRIVATE const SceneView* view, PRIVATE Path* back, int pinned, PRIVATE PathStack* stack,
                          PRIVATE Gathered* sum, GLOBAL event_count* counters) {
  if (pinned < 0) return;
  GLOBAL const int* record = view->patches + pinned * PATCH_INTS;
  if (has(solid_contacts, view) && record[PATCH_BEHIND] == BEHIND_CELL_GAP) back->pinned = record[PATCH_TWIN];
  if (has(polarizer_contacts, view) && record[PATCH_BEHIND] == BEHIND_POLARIZER)
    through_sheet(view, back, record[PATCH_SHEET], pinned, stack, sum, counters);
}

// True if the child is worth following. What leaves for good is added whatever its weight; adc_bailout
// cuts what would go on.
FUNCTION int goes_on(PRIVATE const SceneView* view, PRIVATE Path* child, PRIVATE Gathered* sum,
                     GLOBAL event_count* counters) {
  return is_live(view, child) && !(child->pinned < 0 && escapes(view, child, sum)) &&
         keep_bright(view, child, sum, counters);
}

FUNCTION int leaves_cell(PRIVATE const Event* event) { return event->lead == KEY_EXIT || event->met_patch >= 0; }

// Of faces that wear a plugin's surface, its use, per lane; -1: a bare face.
FUNCTION lane_int surfaces_met(PRIVATE const SceneView* view, PRIVATE const Event* event, int cell) {
  lane_int use = lane_ints(-1);
  int first = cell_of(view, cell)[CELL_FIRST_FACE], count = cell_of(view, cell)[CELL_FACE_COUNT];
  for (int face = first; face < first + count; ++face) {
    int worn = view->faces[face * FACE_INTS + FACE_SURFACE];
    if (worn >= 0) use = pick(event->hit.face == lane_ints(face), lane_ints(worn), use);
  }
  return use;
}

FUNCTION Interface interface_between(PRIVATE const SceneView* view, PRIVATE const Event* event, int cell, int target) {
  Interface face;
  face.normal = event->hit.normal;
  face.medium1 = cell_of(view, cell)[CELL_MEDIUM];
  face.medium2 = cell_of(view, target)[CELL_MEDIUM];
  face.from_inside = leaves_cell(event);
  face.surface = lane_ints(-1);
  if (has_surfaces(view)) face.surface = surfaces_met(view, event, face.from_inside ? cell : target);
  return face;
}

// A face between two media: the path becomes the lighter child, the heavier one waits. False if none is left.
FUNCTION int through_face(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE const Event* event,
                          PRIVATE PathStack* stack, PRIVATE Gathered* sum, GLOBAL event_count* counters) {
  int cell = path->ray.cell, target = cell_beyond(view, path, event);
  int exits = leaves_cell(event);
  Interface face = interface_between(view, event, cell, target);
  int pinned = path->pinned;
  path->pinned = -1;
  Path refracted = split(view, path, face, sum);
  change_cell(view, &refracted, target);
  if (!exits) put_on_face(&refracted, &event->hit, lanes(-1));
  refracted.ray.from_cell = exits ? cell : -1;
  path->ray.from_cell = exits ? -1 : target;
  refracted.ray.from_sheet = path->ray.from_sheet = -1;
  if (exits) {
    meet_behind(view, &refracted, event, cell, stack, sum, counters);
  } else {
    meet_before(view, path, pinned, stack, sum, counters);
  }
  int through = goes_on(view, &refracted, sum, counters);
  int back = goes_on(view, path, sum, counters);
  if (through && back) {
    int heavier = sum_lanes(path_weight(view, &refracted.jones)) > sum_lanes(path_weight(view, &path->jones));
    push(view, stack, heavier ? refracted : *path, sum, counters);
    if (!heavier) *path = refracted;
  } else if (through) {
    *path = refracted;
  }
  return through || back;
}

// The lightest child becomes the path, the others wait, the heaviest deepest. False if there is none.
FUNCTION int follow_lightest(PRIVATE const SceneView* view, PRIVATE Children* children, PRIVATE Path* path,
                             PRIVATE PathStack* stack, PRIVATE Gathered* sum, GLOBAL event_count* counters) {
  scalar weight[MOST_CHILDREN];
  for (int i = 0; i < children->count; ++i) weight[i] = sum_lanes(path_weight(view, &children->paths[i].jones));
  for (int left = children->count; left > 0; --left) {
    int heaviest = 0;
    for (int i = 1; i < children->count; ++i)
      if (weight[i] > weight[heaviest]) heaviest = i;
    if (left == 1) {
      *path = children->paths[heaviest];
    } else {
      push(view, stack, children->paths[heaviest], sum, counters);
    }
    weight[heaviest] = -1;
  }
  return children->count > 0;
}

// A face with a crystal on one side or both: all waves of both sides. False if none is left.
FUNCTION int through_crystal_face(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE const Event* event,
                                  PRIVATE PathStack* stack, PRIVATE Gathered* sum, GLOBAL event_count* counters) {
  int cell = path->ray.cell, target = cell_beyond(view, path, event);
  int exits = leaves_cell(event);
  Interface face = interface_between(view, event, cell, target);
  Path back = *path;
  ++back.level;
  back.pinned = back.ray.from_sheet = -1;
  Path through = back;
  change_cell(view, &through, target);
  if (!exits) put_on_face(&through, &event->hit, lanes(-1));
  through.ray.from_cell = exits ? cell : -1;
  back.ray.from_cell = exits ? -1 : target;
  Children reflected, refracted, kept;
  split_waves(view, path, face, &back, &through, &reflected, &refracted, sum, counters);
  kept.count = 0;
  for (int side = 0; side < 2; ++side) {
    PRIVATE Children* sent = side ? &refracted : &reflected;
    for (int i = 0; i < sent->count; ++i) {
      PRIVATE Path* child = &sent->paths[i];
      if (side && exits) meet_behind(view, child, event, cell, stack, sum, counters);
      if (!side && !exits) meet_before(view, child, path->pinned, stack, sum, counters);
      if (goes_on(view, child, sum, counters)) kept.paths[kept.count++] = *child;
    }
  }
  return follow_lightest(view, &kept, path, stack, sum, counters);
}

// One event of the path. False if nothing of it is left.
FUNCTION int step(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE PathStack* stack, PRIVATE Gathered* sum,
                  GLOBAL event_count* counters) {
  Event event;
  if (!next_event(view, path, stack, sum, counters, &event)) return 0;
  go_to(view, path, &event);
  int first_sheet = key_of_sheet(view, 0), first_patch = key_of_patch(view, 0);
  GLOBAL const int* patch = view->patches + event.met_patch * PATCH_INTS;
  if (has(polarizing_sheets, view) && event.lead >= first_sheet && event.lead < first_patch) {
    ++path->level;
    through_sheet(view, path, event.lead - first_sheet, -1, stack, sum, counters);
    return keep_bright(view, path, sum, counters);
  }
  if (has(solid_contacts, view) && event.behind == BEHIND_SEAM) {
    change_cell(view, path, view->patches[patch[PATCH_TWIN] * PATCH_INTS + PATCH_CELL]);
    path->pinned = -1;
    return 1;
  }
  if (has(polarizer_contacts, view) && event.behind == BEHIND_POLARIZER && patch[PATCH_CELL] != path->ray.cell) {
    // a covered face met from outside: through the polarizer, then the face
    int polarizer = view->sheets[patch[PATCH_SHEET] * SHEET_INTS + SHEET_POLARIZER];
    ++path->level;
    if (reflects(view, polarizer)) keep_reflected(view, *path, patch[PATCH_SHEET], -1, stack, sum, counters);
    path->pinned = event.met_patch;
    pass_polarizer(view, path, polarizer);
    return keep_bright(view, path, sum, counters);
  }
  WITNESS(meets_face(path->ray.cell, cell_beyond(view, path, &event), path->level,
                     dot3(path->ray.direction, event.hit.normal)));
  if (is_crystal(view, cell_of(view, path->ray.cell)[CELL_MEDIUM]) ||
      is_crystal(view, cell_of(view, cell_beyond(view, path, &event))[CELL_MEDIUM]))
    return through_crystal_face(view, path, &event, stack, sum, counters);
  return through_face(view, path, &event, stack, sum, counters);
}

// A camera inside a crystal looks along wave normals: the path becomes the crystal's waves of that normal.
FUNCTION int start_in_crystal(PRIVATE const SceneView* view, PRIVATE Path* path, PRIVATE PathStack* stack,
                              PRIVATE Gathered* sum, GLOBAL event_count* counters) {
  int medium = cell_of(view, path->ray.cell)[CELL_MEDIUM];
  if (!has(camera_in_crystal, view) || !is_crystal(view, medium)) return 1;
  WaveMedium m = wave_medium(view, medium);
  vec3 s = path->ray.direction, f = second_axis(path);
  SectionWaves section = waves_of_section(&m, s);
  Wave w[2];
  cplx amplitude[2][2];
  for (int i = 0; i < 2; ++i) {
    w[i].runs = lanes(0) == lanes(0);
    w[i].k = scale3(section.n[i], s);
    w[i].d.re = section.d_re[i];
    w[i].d.im = section.d_im[i];
    cvec3 e, h;
    fields_of_wave(&m, w[i].k, w[i].d.re, w[i].d.im, &e, &h);
    w[i].ray = ray_of_fields(&e, &h);
    // <D, a e + b f>
    cplx on_e = complex_of(dot3(w[i].d.re, path->axis), -dot3(w[i].d.im, path->axis));
    cplx on_f = complex_of(dot3(w[i].d.re, f), -dot3(w[i].d.im, f));
    for (int r = 0; r < jones_rows(view); ++r)
      amplitude[i][r] = cadd(cmul(on_e, path->jones.e[r]), cmul(on_f, path->jones.f[r]));
  }
  Children waves;
  waves.count = 0;
  real gap = section.gap * dot3(s, unit3(add3(w[0].ray, w[1].ray)));
  send_waves(view, path, &m, w, gap, amplitude, &waves, sum);
  return follow_lightest(view, &waves, path, stack, sum, counters);
}

// Follows the tree behind `path` and adds what it brings. Returns the lane-segments traced.
FUNCTION int follow(PRIVATE const SceneView* view, Path path, PRIVATE PathStack* stack, PRIVATE Gathered* sum,
                    GLOBAL event_count* counters) {
  int segments = 0;
  stack->size = 0;
  WITNESS(starts(path_weight(view, &path.jones)));
  if (!start_in_crystal(view, &path, stack, sum, counters)) return 0;
  for (;;) {
    segments += count_lanes(path_weight(view, &path.jones) > lanes(0));
    if (step(view, &path, stack, sum, counters)) continue;
    if (stack->size == 0) return segments;
    path = stack->paths[--stack->size];
  }
}

#endif
