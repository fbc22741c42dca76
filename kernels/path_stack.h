// Paths that wait for their turn, and a path's change from one cell's coordinates to another's.
#ifndef NICOL_PATH_STACK_H
#define NICOL_PATH_STACK_H
#include "path.h"

#ifndef STACK_SIZE
#define STACK_SIZE 64
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
  add_cut_off(sum, path_weight(view, &path.jones));
}

// Moves a path from its cell into another one's coordinates.
FUNCTION void change_cell(PRIVATE const SceneView* view, PRIVATE Path* path, int cell) {
  vec3 shift = sub3(cell_centre(view, path->ray.cell), cell_centre(view, cell));
  path->ray.position = add3(path->ray.position, shift);
  path->ray.cell = cell;
}

#endif
