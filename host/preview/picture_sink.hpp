// Where the renderer's frames go that are parts of a picture: some of its pixels, some samples of each.
#pragma once
#include <array>
#include <mutex>
#include <vector>

#include "host/preview/picture.hpp"

namespace nicol::preview {

class PictureSink final : public FrameSink {
 public:
  // `lock` is held while the picture changes.
  PictureSink(Picture& picture, std::mutex& lock) : picture_(picture), lock_(lock) {}

  // The next frame is the first of another picture of the same size; until it comes the one before stays whole.
  void begin_anew(bool anew) { anew_ = anew; }

  // The next frame is a row of these pixels of the picture, each the mean of `samples` samples; each shows for a block of step x step.
  void expect(const std::int32_t* pixels, std::size_t count, int samples, int step);
  void write(const Frame& frame) override;

  // The next frame is the whole picture, in place of what is there.
  void write_whole(Frame&& frame);

  // Sum over pixels, wavelengths and Stokes components of the squares of what frames changed since the last call, of
  // pixels that had samples already.
  double take_change2();

 private:
  void mix_in(const Frame& frame);
  void fill_blocks();

  Picture& picture_;
  std::mutex& lock_;
  const std::int32_t* pixels_ = nullptr;
  std::size_t count_ = 0;
  int samples_ = 1, step_ = 1;
  bool anew_ = false;
  double change2_ = 0;
};

// S0 per nm: mean over the traced pixels and the wavelengths.
double mean_radiance_of(const Picture& picture);

}  // namespace nicol::preview
