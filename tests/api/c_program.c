/* libnicol from C99: a scene from text with an include file of its own, rendered with progress, read and written nowhere. */
#include <stdio.h>
#include <string.h>

#include "nicol.h"

static int failures = 0;

static void expect(int right, const char* what) {
  if (right) return;
  printf("failed: %s (%s)\n", what, nicol_last_error());
  ++failures;
}

static int include(void* user, const char* name, nicol_include* answer) {
  const char* text = "#declare Sky = 0.5;";
  ++*(int*)user;
  return strcmp(name, "sky.inc") == 0 && nicol_include_set_text(answer, text, strlen(text)) != NICOL_OK;
}

static int progress(void* user, double fraction, double seconds, double seconds_left) {
  (void)seconds;
  (void)seconds_left;
  *(double*)user = fraction;
  return 0;
}

static const char* const scene_text =
    "#include \"sky.inc\"\n"
    "global_settings { mm_per_unit 1 wavelengths { 450, 550, 650 } }\n"
    "camera { location <0, 30, -30> right x*image_width/image_height angle 30 look_at 0 }\n"
    "background { spectrum { e scale Sky } }\n"
    "box { <-4, 0, -4>, <4, 6, 4> interior { ior 1.5 } }\n";

static void render(nicol_scene* scene) {
  nicol_render_options options;
  nicol_picture* picture = NULL;
  const float* stokes = NULL;
  int32_t width = 0, height = 0;
  double fraction = 0;
  memset(&options, 0, sizeof options);
  options.struct_size = sizeof options;
  options.progress = progress;
  options.user = &fraction;
  expect(nicol_render(scene, &options, &picture) == NICOL_OK, "render");
  expect(fraction > 0.99, "progress");
  expect(nicol_picture_size(picture, &width, &height) == NICOL_OK && width == 16 && height == 12, "size");
  expect(nicol_picture_stokes(picture, &stokes) == NICOL_OK && stokes != NULL && stokes[0] > 0, "stokes");
  expect(nicol_picture_write(picture, "/nowhere/a.exr") == NICOL_ERROR_OUTPUT, "write");
  nicol_picture_release(picture);
}

int main(void) {
  nicol_context* context = NULL;
  nicol_scene* scene = NULL;
  nicol_scene_options options;
  int asked = 0;
  expect(nicol_abi_version() == NICOL_ABI_VERSION, "version");
  expect(nicol_context_create(NULL, &context) == NICOL_OK, "context");
  memset(&options, 0, sizeof options);
  options.struct_size = sizeof options;
  options.width = 16;
  options.height = 12;
  options.include = include;
  options.user = &asked;
  expect(nicol_scene_load_text(context, "c.pov", scene_text, strlen(scene_text), &options, &scene) == NICOL_OK, "scene");
  expect(asked == 1, "include");
  if (scene != NULL) render(scene);
  nicol_scene_release(scene);
  nicol_context_release(context);
  return failures == 0 ? 0 : 1;
}
