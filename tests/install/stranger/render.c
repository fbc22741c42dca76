/* render NAME: a picture into NAME.exr and NAME.png, and what it is off by on standard output. */
#include <nicol.h>
#include <stdio.h>
#include <string.h>

#include "scene.h"

static int failed(nicol_status status) {
  if (status == NICOL_OK) return 0;
  fprintf(stderr, "%s: %s\n", nicol_status_text(status), nicol_last_error());
  return 1;
}

static int write_as(const nicol_picture* picture, const char* name, const char* suffix) {
  char path[1024];
  snprintf(path, sizeof path, "%s%s", name, suffix);
  return failed(nicol_picture_write(picture, path));
}

static int print_budget(const nicol_picture* picture) {
  size_t i, count = nicol_picture_budget_count(picture);
  for (i = 0; i < count; ++i) {
    nicol_budget_line line;
    memset(&line, 0, sizeof line);
    line.struct_size = sizeof line;
    if (failed(nicol_picture_budget_line(picture, i, &line))) return 1;
    printf("%s %g\n", line.source, line.rms);
  }
  return count == 0;
}

int main(int argc, char** argv) {
  nicol_context* context = NULL;
  nicol_scene* scene = NULL;
  nicol_picture* picture = NULL;
  nicol_scene_options scene_options;
  nicol_render_options render_options;
  int bad;
  memset(&scene_options, 0, sizeof scene_options);
  scene_options.struct_size = sizeof scene_options;
  scene_options.width = 32;
  scene_options.height = 24;
  memset(&render_options, 0, sizeof render_options);
  render_options.struct_size = sizeof render_options;
  render_options.want_error_budget = 1;
  bad = argc != 2 || failed(nicol_context_create(NULL, &context)) ||
        failed(nicol_scene_load_text(context, "cube.pov", scene_text, strlen(scene_text), &scene_options, &scene)) ||
        failed(nicol_render(scene, &render_options, &picture)) || write_as(picture, argv[1], ".exr") ||
        write_as(picture, argv[1], ".png") || print_budget(picture);
  nicol_picture_release(picture);
  nicol_scene_release(scene);
  nicol_context_release(context);
  return bad;
}
