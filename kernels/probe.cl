// Entry point of `nicol probe`: one work-item per problem (build with LANES=1).
#include "probe.h"

#ifndef LOCAL_SIZE
#define LOCAL_SIZE 1
#endif

__kernel __attribute__((reqd_work_group_size(LOCAL_SIZE, 1, 1)))
void probe(__global const scalar* problems, __global scalar* answers, int count) {
  int i = (int)get_global_id(0);
  if (i < count) solve_problem(problems + (size_t)i * PROBE_SCALARS, answers + (size_t)i * ANSWER_SCALARS);
}
