// Where a ray in a cell goes next: out of the cell's faces, into a cell inside it, or onto a sheet.
//
// A cell is convex: the ray leaves it by the nearest face with d.N > 0 and enters another one by the
// farthest face with d.N < 0, if that comes before its nearest exit. The solid it just left is
// passed over (a convex solid cannot be met twice), so there is no self-hit and no epsilon. Distances
// are clamped at 0, ties go to the lower index. Keys say what was met, one per lane.
#ifndef NICOL_HIT_H
#define NICOL_HIT_H
#include "scene_view.h"

enum { KEY_MISS = -1, KEY_EXIT = 0, KEY_FIRST_CELL = 1 };
#define key_of_cell(cell) (KEY_FIRST_CELL + (cell))
#define key_of_sheet(view, sheet) (KEY_FIRST_CELL + (view)->header[HEADER_CELL_COUNT] + (sheet))
#define key_of_patch(view, patch)                                                               \
  (KEY_FIRST_CELL + (view)->header[HEADER_CELL_COUNT] + (view)->header[HEADER_SHEET_COUNT] + (patch))

// A ray in a cell: position in mm from the cell's centre, unit direction.
typedef struct {
  vec3 position, direction;
  int cell;
  int from_cell, from_sheet;  // what it just left (-1: none)
} Ray;

typedef struct {
  real depth_mm;
  vec3 normal;    // of what was met, turned forward: d.normal > 0
  real offset;    // of a face: outward normal . p = offset in the coordinates of its cell
  lane_int key;
  lane_int face;  // index of the face met (exits and entries)
} Hit;

#define FAR_MM lanes(1e30f)

FUNCTION void meet_exits(PRIVATE const SceneView* view, PRIVATE const Ray* ray, PRIVATE Hit* hit) {
  int first = cell_of(view, ray->cell)[CELL_FIRST_FACE];
  int count = cell_of(view, ray->cell)[CELL_FACE_COUNT];
  GLOBAL const scalar* planes = view->face_reals + first * FACE_REALS;
  for (int i = 0; i < count; ++i) {
    vec3 n = broadcast(planes + i * FACE_REALS);
    real forward = dot3(n, ray->direction);
    real gap = lanes(planes[i * FACE_REALS + 3]) - dot3(n, ray->position);
    mask ahead = forward > lanes(0);
    real depth = gap / pick(ahead, forward, lanes(1));
    mask nearer = ahead & (depth < hit->depth_mm);
    hit->depth_mm = pick(nearer, depth, hit->depth_mm);
    hit->normal = pick3(nearer, n, hit->normal);
    hit->offset = pick(nearer, lanes(planes[i * FACE_REALS + 3]), hit->offset);
    hit->face = pick(nearer, lane_ints(first + i), hit->face);
  }
  if (count > 0) {
    hit->key = pick(hit->depth_mm < FAR_MM, lane_ints(KEY_EXIT), hit->key);
    hit->depth_mm = pick(hit->depth_mm > lanes(0), hit->depth_mm, lanes(0));
  }
}

FUNCTION void meet_cell(PRIVATE const SceneView* view, PRIVATE const Ray* ray, int cell, PRIVATE Hit* hit) {
  vec3 position = sub3(add3(ray->position, cell_centre(view, ray->cell)), cell_centre(view, cell));
  if (has(many_solids, view)) {  // sphere around the cell first
    scalar radius = view->cell_reals[cell * CELL_REALS + CELL_RADIUS];
    real b = dot3(position, ray->direction);
    real off_axis2 = dot3(position, position) - b * b;
    if (!any_lane(off_axis2 <= lanes(radius * radius))) return;
  }
  int first = cell_of(view, cell)[CELL_FIRST_FACE];
  int count = cell_of(view, cell)[CELL_FACE_COUNT];
  GLOBAL const scalar* planes = view->face_reals + first * FACE_REALS;
  real in = -FAR_MM, out = FAR_MM, offset = lanes(0);
  vec3 normal = ray->direction;
  lane_int face = lane_ints(first);
  for (int i = 0; i < count; ++i) {
    vec3 n = broadcast(planes + i * FACE_REALS);
    real forward = dot3(n, ray->direction);
    real gap = lanes(planes[i * FACE_REALS + 3]) - dot3(n, position);
    // a ray along the face counts as leaving far away, or as never inside
    mask level = forward == lanes(0);
    real depth = pick(level, pick(gap < lanes(0), -FAR_MM, FAR_MM), gap / pick(level, lanes(1), forward));
    mask entering = forward < lanes(0);
    mask later = entering & (depth > in);
    in = pick(later, depth, in);
    normal = pick3(later, n, normal);
    offset = pick(later, lanes(planes[i * FACE_REALS + 3]), offset);
    face = pick(later, lane_ints(first + i), face);
    out = pick(not_mask(entering) & (depth < out), depth, out);
  }
  // a plate thinner than the rounding of its distance is met; so is one that rounding has the ray already in, for it
  // comes from outside
  mask met = (in <= out) & (out > lanes(0)) & (in < hit->depth_mm);
  hit->depth_mm = pick(met, pick(in > lanes(0), in, lanes(0)), hit->depth_mm);
  hit->normal = pick3(met, scale3(lanes(-1), normal), hit->normal);
  hit->offset = pick(met, offset, hit->offset);
  hit->face = pick(met, face, hit->face);
  hit->key = pick(met, lane_ints(key_of_cell(cell)), hit->key);
}

// Inside all edge planes; all of them if there are none.
FUNCTION mask inside_edges(PRIVATE const SceneView* view, int first, int count, vec3 point, mask so_far) {
  for (int i = first; i < first + count; ++i) {
    GLOBAL const scalar* edge = view->edges + i * EDGE_REALS;
    so_far = so_far & (dot3(broadcast(edge), point) <= lanes(edge[3]));
  }
  return so_far;
}

FUNCTION mask inside_ring(vec3 point, vec3 centre, scalar radius2, scalar hole2) {
  vec3 r = sub3(point, centre);
  real distance2 = dot3(r, r);
  return (distance2 <= lanes(radius2)) & (distance2 >= lanes(hole2));
}

// How far back along the ray the solid begins that it just left or was thrown back from; negative.
FUNCTION real depth_of_solid_left(PRIVATE const SceneView* view, PRIVATE const Ray* ray) {
  vec3 position = sub3(add3(ray->position, cell_centre(view, ray->cell)), cell_centre(view, ray->from_cell));
  int first = cell_of(view, ray->from_cell)[CELL_FIRST_FACE];
  int count = cell_of(view, ray->from_cell)[CELL_FACE_COUNT];
  real in = -FAR_MM;
  for (int i = first; i < first + count; ++i) {
    GLOBAL const scalar* plane = view->face_reals + i * FACE_REALS;
    real forward = dot3(broadcast(plane), ray->direction);
    mask entering = forward < lanes(0);
    real depth = (lanes(plane[3]) - dot3(broadcast(plane), position)) / pick(entering, forward, lanes(1));
    in = pick(entering & (depth > in), depth, in);
  }
  return in;
}

// Depth at which the ray crosses a sheet, FAR_MM where it does not. No sheet lies inside the solid just left: where the
// crossing seems to, rounding has put it there, and it lies at the nearer end.
FUNCTION real cross_sheet(PRIVATE const SceneView* view, PRIVATE const Ray* ray, int sheet, PRIVATE vec3* normal) {
  GLOBAL const int* record = view->sheets + sheet * SHEET_INTS;
  GLOBAL const scalar* reals = view->sheet_reals + sheet * SHEET_REALS;
  vec3 position = sub3(add3(ray->position, cell_centre(view, ray->cell)), broadcast(reals + SHEET_CENTRE));
  vec3 n = broadcast(reals + SHEET_PLANE);
  real forward = dot3(n, ray->direction);
  mask level = forward == lanes(0);
  real depth = (lanes(reals[SHEET_PLANE + 3]) - dot3(n, position)) / pick(level, lanes(1), forward);
  vec3 point = along(depth, ray->direction, position);
  mask within = not_mask(level);
  within = inside_edges(view, record[SHEET_FIRST_EDGE], record[SHEET_EDGE_COUNT], point, within);
  if (has(discs, view) && record[SHEET_HAS_DISC])
    within = within & inside_ring(point, broadcast(reals + SHEET_DISC_CENTRE), reals[SHEET_RADIUS2], reals[SHEET_HOLE2]);
  mask met = within & (depth > lanes(0));
  if (ray->from_cell >= 0) {
    mask behind = within & (depth <= lanes(0)) & (depth > lanes(-view->cell_reals[ray->from_cell * CELL_REALS + CELL_RADIUS]));
    if (any_lane(behind)) {
      mask near = behind & (depth > lanes(0.5f) * depth_of_solid_left(view, ray));
      depth = pick(near, lanes(0), depth);
      met = met | near;
    }
  }
  *normal = pick3(forward < lanes(0), scale3(lanes(-1), n), n);
  return pick(met, depth, FAR_MM);
}

FUNCTION void meet_sheet(PRIVATE const SceneView* view, PRIVATE const Ray* ray, int sheet, PRIVATE Hit* hit) {
  vec3 normal;
  real depth = cross_sheet(view, ray, sheet, &normal);
  mask met = depth < hit->depth_mm;
  hit->depth_mm = pick(met, depth, hit->depth_mm);
  hit->normal = pick3(met, normal, hit->normal);
  hit->key = pick(met, lane_ints(key_of_sheet(view, sheet)), hit->key);
}

FUNCTION Hit no_hit(PRIVATE const Ray* ray) {
  Hit hit;
  hit.depth_mm = FAR_MM;
  hit.normal = ray->direction;
  hit.offset = lanes(0);
  hit.key = lane_ints(KEY_MISS);
  hit.face = lane_ints(0);
  return hit;
}

FUNCTION Hit next_hit(PRIVATE const SceneView* view, PRIVATE const Ray* ray) {
  Hit hit = no_hit(ray);
  GLOBAL const int* cell = cell_of(view, ray->cell);
  meet_exits(view, ray, &hit);
  if (ray->cell == 0 || has(nested_solids, view)) {
    for (int i = 0; i < cell[CELL_CHILD_COUNT]; ++i) {
      int child = view->lists[cell[CELL_FIRST_CHILD] + i];
      if (child != ray->from_cell) meet_cell(view, ray, child, &hit);
    }
  }
  if (has(luminous_sheets, view) || has(polarizing_sheets, view)) {
    for (int i = 0; i < cell[CELL_SHEET_COUNT]; ++i) {
      int sheet = view->lists[cell[CELL_FIRST_SHEET] + i];
      if (sheet != ray->from_sheet) meet_sheet(view, ray, sheet, &hit);
    }
  }
  return hit;
}

// Where a point on the plane of a patch's face lies inside the patch. Position from the centre of its cell.
FUNCTION mask inside_patch(PRIVATE const SceneView* view, int patch, vec3 point, mask so_far) {
  GLOBAL const int* record = view->patches + patch * PATCH_INTS;
  so_far = inside_edges(view, record[PATCH_FIRST_EDGE], record[PATCH_EDGE_COUNT], point, so_far);
  if (has(discs, view) && record[PATCH_HAS_DISC]) {
    GLOBAL const scalar* reals = view->patch_reals + patch * PATCH_REALS;
    so_far = so_far & inside_ring(point, broadcast(reals + PATCH_DISC_CENTRE), reals[PATCH_RADIUS2], reals[PATCH_HOLE2]);
  }
  return so_far;
}

// The patch under a point on the faces in `face`, -1 where there is none. Position from the cell's centre.
FUNCTION lane_int patch_under(PRIVATE const SceneView* view, int cell, vec3 point, lane_int face) {
  lane_int found = lane_ints(-1);
  int first = cell_of(view, cell)[CELL_FIRST_PATCH], count = cell_of(view, cell)[CELL_PATCH_COUNT];
  for (int i = first; i < first + count; ++i) {
    mask on = face == lane_ints(view->patches[i * PATCH_INTS + PATCH_FACE]);
    if (!any_lane(on)) continue;
    on = inside_patch(view, i, point, on);
    found = pick(on & (found < lane_ints(0)), lane_ints(i), found);
  }
  return found;
}

#endif
