// The steps in which a picture gets finer: every 16th pixel, ..., every pixel, then further samples of all.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace nicol::preview {

struct Stage {
  int step = 1;                              // of the grid that is whole afterwards; samples: 1
  int sample_begin = 0, sample_end = 1;      // of pixel_samples(); step > 1 and the first of step 1: the centre
  bool adaptive = false;                     // the last: to the scene's sampling error, where it has one
};

// first_step: a power of two. most_samples: odd counts 3, 5, 11, 23, ... up to it.
std::vector<Stage> stages(int first_step, int most_samples, bool adaptive);

// The pixels that a stage traces, row by row: those of its grid that are in no coarser one (first: all of its grid).
std::vector<std::int32_t> pixels_of(const Stage& stage, bool first, int width, int height);

inline constexpr int coarsest_step = 32;

// The coarsest grid whose picture takes about as long as the eye takes for one; 16 when nothing is known (0).
int first_step(int width, int height, double pixel_seconds);

}  // namespace nicol::preview
