// Pictures that get finer: what an untraced pixel shows.
#include "traced.hpp"

namespace nicol::preview {

TEST_CASE("picture: a new one has nothing traced") {
  const Picture picture = make_picture(5, 3, {500, 600}, {100, 100});
  CHECK(picture.frame.samples.size() == 15);
  CHECK(picture.frame.stokes.size() == 4 * 2 * 15);
  CHECK(picture.frame.cut_off.size() == 15);
  CHECK(picture.rgb.size() == 45);
  CHECK(picture.stokes_y.size() == 60);
  CHECK(picture.step == 0);
  CHECK(shown_pixel(picture, 4, 2) == -1);
}

TEST_CASE("picture: an untraced pixel shows the corner of the smallest traced block") {
  Picture picture = make_picture(37, 21, {550}, {1});
  for (int y = 0; y < 21; y += 8)
    for (int x = 0; x < 37; x += 8) trace(picture, x, y, {1, 0, 0, 0});
  CHECK(shown_pixel(picture, 15, 7) == 0 * 37 + 8);
  CHECK(shown_pixel(picture, 36, 20) == 16 * 37 + 32);
  trace(picture, 12, 4, {1, 0, 0, 0});
  CHECK(shown_pixel(picture, 15, 7) == 4 * 37 + 12);
  CHECK(shown_pixel(picture, 11, 7) == 8);
  CHECK(shown_pixel(picture, 12, 4) == 4 * 37 + 12);
}

TEST_CASE("picture: forgotten, it still shows its colours but knows no spectrum") {
  Picture picture = uniform(4, 4, {1, 0, 0, 0});
  const auto rgb = picture.rgb;
  const auto version = picture.version;
  forget(picture);
  CHECK(picture.rgb == rgb);
  CHECK(picture.step == 0);
  CHECK(picture.version > version);
  CHECK(shown_pixel(picture, 2, 2) == -1);
}

}  // namespace nicol::preview
