// Camera rays and their polarization axes.
#ifndef NICOL_CAMERA_H
#define NICOL_CAMERA_H
#include "trace.h"

// The path through the point (u, v) of the picture (0..1 from the left and from the top), and the axis that
// shows right in the picture, across the ray. With an analyzer the path starts in the state it passes.
FUNCTION Path camera_path(PRIVATE const SceneView* view, real u, real v, PRIVATE vec3* picture_x) {
  GLOBAL const scalar* camera = view->camera;
  vec3 location = broadcast(camera + CAMERA_LOCATION), direction = broadcast(camera + CAMERA_DIRECTION);
  vec3 right = broadcast(camera + CAMERA_RIGHT), up = broadcast(camera + CAMERA_UP);
  vec3 offset = add3(scale3(u, right), scale3(v, up));
  Path path;
  int parallel = has(orthographic, view);
  path.ray.position = parallel ? add3(location, offset) : location;
  path.ray.direction = unit3(parallel ? direction : add3(direction, offset));
  path.ray.cell = 0;
  path.ray.from_cell = path.ray.from_sheet = -1;
  path.level = 0;
  path.pinned = -1;
  carry_any(&path);
  int cell = view->header[HEADER_CAMERA_CELL];
  path.ray.position = sub3(path.ray.position, cell_centre(view, cell));
  path.ray.cell = cell;
  *picture_x = unit3(along(-dot3(right, path.ray.direction), path.ray.direction, right));
  path.axis = *picture_x;
  cplx zero = complex_of(lanes(0), lanes(0)), one = complex_of(lanes(1), lanes(0));
  path.jones.e[0] = one;
  path.jones.f[0] = zero;
  path.jones.e[1] = zero;
  path.jones.f[1] = one;
  int analyzer = view->header[HEADER_CAMERA_POLARIZER];
  if (has_elements(view) && analyzer >= 0 && is_element(view, analyzer)) {
    pass_element(view, &path, analyzer);
    if (!has(polarization, view)) return path;
    // the rows stay those of the picture's axes, and the path goes on in them
    turn_axes(view, &path.jones, dot3(*picture_x, path.axis), dot3(*picture_x, second_axis(&path)));
    path.axis = *picture_x;
    return path;
  }
  if ((has(ideal_polarizer, view) || has(calcite_polarizer, view)) && analyzer >= 0) {
    PassingState state = passing_state(view, analyzer, path.ray.direction);
    path.axis = state.axis;
    real amplitude = state.amplitude;
    if (!has(polarization, view)) amplitude = lanes(0.5) * amplitude * amplitude;
    path.jones.e[0] = complex_of(amplitude, lanes(0));
    path.jones.f[1] = zero;
  }
  return path;
}

// Stokes in the axes (axis, axis x d) turned to the picture's (x, y).
FUNCTION void turn_to_picture(PRIVATE Gathered* sum, vec3 axis, vec3 picture_x, vec3 direction) {
  real c = dot3(axis, picture_x), s = dot3(axis, cross3(picture_x, direction));
  real c2 = c * c - s * s, s2 = lanes(2) * c * s;
  real s1 = sum->stokes[1];
  sum->stokes[1] = s1 * c2 - sum->stokes[2] * s2;
  sum->stokes[2] = s1 * s2 + sum->stokes[2] * c2;
}

#endif
