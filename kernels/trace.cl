// Entry point of the renderer.
#include "render.h"

#ifndef LOCAL_SIZE
#define LOCAL_SIZE 1
#endif

__kernel __attribute__((reqd_work_group_size(LOCAL_SIZE, 1, 1)))
void trace(__global const int* ints, __global const scalar* reals, __global const scalar* tables,
           __global const scalar* samples, __global const int* pixels, __global scalar* out, __global uint* counters,
           int listed, int first_item, int item_count, int sample_begin, int sample_end) {
  int g = (int)get_global_id(0);
  if (g >= item_count) return;
  render_item(ints, reals, tables, samples, pixels, out + (size_t)g * OUT_COMPONENTS * LANES, counters, listed,
              first_item + g, sample_begin, sample_end);
}
