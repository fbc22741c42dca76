// One work-item: the samples of one pixel at LANES wavelengths, or of LANES pixels at one wavelength.
#ifndef NICOL_RENDER_H
#define NICOL_RENDER_H
#include "camera.h"

// Stokes in the picture's axes, and cut-off, of one sample.
FUNCTION Gathered light_of_sample(PRIVATE const SceneView* view, real u, real v, mask in_use, PRIVATE PathStack* stack,
                                  GLOBAL event_count* counters, PRIVATE int* segments) {
  vec3 picture_x;
  Path path = camera_path(view, u, v, &picture_x);
  path.jones = keep_lanes(view, in_use, path.jones);
  vec3 axis = path.axis, direction = path.ray.direction;
  Gathered sum;
  for (int i = 0; i < 4; ++i) sum.stokes[i] = sum.lost[i] = lanes(0);
  sum.cut_off = sum.lost_cut_off = lanes(0);
  sum.signature = lane_ints(0);
  sum.energy_off = lanes(0) != lanes(0);
  sum.cones = lanes(0) != lanes(0);
  *segments += follow(view, path, stack, &sum, counters);
  turn_to_picture(&sum, axis, picture_x, direction);
  if (any_lane(sum.energy_off)) count_event(counters, COUNT_ENERGY);
  if (any_lane(sum.stokes[0] != sum.stokes[0])) count_event(counters, COUNT_NAN);
  real polarized2 = lanes(0);
  for (int i = 1; i < 4; ++i) polarized2 += sum.stokes[i] * sum.stokes[i];
  real slack = lanes(sizeof(scalar) == 8 ? 1e-12f : 1e-5f);
  if (any_lane(polarized2 > sum.stokes[0] * sum.stokes[0] * (lanes(1) + slack))) count_event(counters, COUNT_STOKES);
  return sum;
}

FUNCTION real real_of_lanes(lane_int v) {
  real r = lanes(0);
  for (int lane = 0; lane < LANES; ++lane) ((PRIVATE scalar*)&r)[lane] = (scalar)((PRIVATE lane_int_scalar*)&v)[lane];
  return r;
}

// Writes the sum over samples [sample_begin, sample_end) to `out` (OUT_COMPONENTS x LANES scalars). `samples`
// holds x, y pairs, 0..1 within the pixel. `pixels`: the picture's pixels that are wanted, listed of them, in place of all (listed 0).
FUNCTION void render_item(GLOBAL const int* ints, GLOBAL const scalar* reals, GLOBAL const scalar* tables,
                          GLOBAL const scalar* samples, GLOBAL const int* pixels, GLOBAL scalar* out,
                          GLOBAL event_count* counters, int listed, int item, int sample_begin, int sample_end) {
  int width = ints[HEADER_WIDTH], height = ints[HEADER_HEIGHT];
  SceneView view = view_scene(ints, reals, tables, 0);
  int over_pixels = has(lanes_over_pixels, &view);
  int parts = over_pixels ? ints[HEADER_LAMBDA_COUNT] : view.stride / LANES;
  int part = item % parts, pixel = item / parts;
  int pixel_count = listed > 0 ? listed : width * height;
  view.row_offset = over_pixels ? part : part * LANES;
  scalar px[LANES], py[LANES];  // pixel of each lane, from the picture's centre
  for (int lane = 0; lane < LANES; ++lane) {
    int p = over_pixels ? pixel * LANES + lane : pixel;
    if (p >= pixel_count) p = pixel_count - 1;
    if (listed > 0) p = pixels[p];
    px[lane] = (scalar)(p % width) - (scalar)0.5 * (scalar)width;
    py[lane] = (scalar)0.5 * (scalar)height - (scalar)(p / width);
  }
  real x0 = lanes(0), y0 = lanes(0);
  for (int lane = 0; lane < LANES; ++lane) {
    ((PRIVATE scalar*)&x0)[lane] = px[lane];
    ((PRIVATE scalar*)&y0)[lane] = py[lane];
  }
  // lanes beyond the last channel or pixel are dead from the start
  real index = lanes(0);
  for (int lane = 0; lane < LANES; ++lane) ((PRIVATE scalar*)&index)[lane] = (scalar)lane;
  int used = over_pixels ? pixel_count - pixel * LANES : ints[HEADER_LAMBDA_COUNT] - part * LANES;
  mask in_use = index < lanes((scalar)used);
  real total[OUT_COMPONENTS];
  for (int i = 0; i < OUT_COMPONENTS; ++i) total[i] = lanes(0);
  lane_int signature = lane_ints(0);
  mask alike = lanes(0) == lanes(0);
  int segments = 0;
  PathStack stack;
  int azimuths = has(conical_rays, &view) && ints[HEADER_CONICAL_RAYS] > 0 ? ints[HEADER_CONICAL_RAYS] : 1;
  for (int s = sample_begin; s < sample_end; ++s) {
    real u = (x0 + lanes(samples[2 * s])) / lanes((scalar)width);
    real v = (y0 - lanes(samples[2 * s + 1])) / lanes((scalar)height);
    real s0_before = total[OUT_STOKES];
    mask taken = in_use;  // lanes that still ask for azimuths
    for (int azimuth = 0; azimuth < azimuths && any_lane(taken); ++azimuth) {
      if (has(conical_rays, &view)) {
        cplx turn = rotation_of(lanes(((scalar)azimuth + (scalar)0.5) / (scalar)(4 * azimuths)), lanes(0), lanes(1));
        view.conical_cos = turn.re;
        view.conical_sin = turn.im;
      }
      Gathered sum = light_of_sample(&view, u, v, taken, &stack, counters, &segments);
      taken = taken & sum.cones;  // for the others all azimuths are alike
      real share = pick(sum.cones, lanes((scalar)1 / (scalar)azimuths), lanes(1));
      real length2 = lanes(0);
      for (int i = 0; i < 4; ++i) {
        total[OUT_STOKES + i] += share * sum.stokes[i];
        length2 += sum.stokes[i] * sum.stokes[i];
      }
      total[OUT_CUT_OFF] += share * sum.cut_off;
      total[OUT_SQUARE] += share * length2;
      if (has(path_signatures, &view)) {
        if (s == sample_begin && azimuth == 0) signature = sum.signature;
        alike = alike & (signature == sum.signature);
      }
    }
    total[OUT_HALVES] += lanes((s + 1) / 2 % 2 == 0 ? 1 : -1) * (total[OUT_STOKES] - s0_before);
  }
  total[OUT_SIGNATURE] = pick(alike, real_of_lanes(signature >> 7), lanes(-1));  // 23 bits: whole in a float
  for (int i = 0; i < OUT_COMPONENTS; ++i) store_lanes(total[i], out + i * LANES);
  add_event(counters, COUNT_SEGMENTS, (event_count)segments);
}

#endif
