/* Plugins for nicol: a shared object with one entry, nicol_plugin_v1, that registers what it brings. C99 and C++; nothing to link.

   int nicol_plugin_v1(const nicol_host_v1* host) {
     host->add_dispersion(host, &my_formula);
     return NICOL_PLUGIN_OK;
   }

   Scenes     ask by name and with parameters: index { plugin { "NAME" temperature 350 } }, spectrum { plugin { ... } },
              solid { plugin { ... } interior { ... } }. NAME of an entry, or FILE/NAME where two files have the same.
   Where      --plugin FILE-or-NAME, the folders of NICOL_PLUGIN_PATH, folders given with +L, and nicol's own plugins folder. Loading
              runs code, so it is never the scene's folder or the working directory unasked.
   Structs    begin with struct_size, to be set to sizeof of the struct; what is not said stays zero.
   Texts      are UTF-8, ended by a zero. Names are letters, digits and _, not beginning with a digit. What is handed to an add_
              function is copied, but for `user` and the functions.
   Errors     A callback that cannot answer calls host->set_message and returns anything but NICOL_PLUGIN_OK. A C++ exception that leaves a
              callback is caught and told, and that plugin is not called again.
   Threads    Calls into one file take turns unless the entry sets NICOL_PLUGIN_THREAD_SAFE. No file is ever unloaded.
   host       is another one for each call; it and what it hands out end with the call. Its functions refuse (NICOL_PLUGIN_REFUSED, NULL)
              what does not belong to the call: add_point is for solids only, add_dispersion for nicol_plugin_v1 only, and so on. */
#ifndef NICOL_PLUGIN_H
#define NICOL_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { NICOL_PLUGIN_OK = 0, NICOL_PLUGIN_ERROR = 1, NICOL_PLUGIN_REFUSED = 2 };
enum { NICOL_PLUGIN_THREAD_SAFE = 1 };                      /* flags of an entry */
enum { NICOL_PARAMETER_NUMBER = 0, NICOL_PARAMETER_TEXT = 1 };

typedef struct nicol_host_v1 nicol_host_v1;

/* A number with its unit, or a text, as the name of a file. */
typedef struct nicol_parameter_v1 {
  uint32_t struct_size;
  int32_t kind;             /* NICOL_PARAMETER_... */
  const char* name;
  const char* unit;         /* "K", "nm", "deg"; NULL or "": dimensionless */
  const char* meaning;      /* for lists; may be NULL */
  int32_t has_default;      /* 0: the scene must say it */
  int32_t has_bounds;       /* 1: least and most hold */
  double default_number;
  double least, most;
  const char* default_text;
} nicol_parameter_v1;

/* What the scene says: numbers in the order of the parameters that are numbers, texts likewise. */
typedef struct nicol_values_v1 {
  uint32_t struct_size;
  uint32_t number_count;
  const double* numbers;
  const char* const* texts;
  uint32_t text_count;
} nicol_values_v1;

/* Refractive index n (> 0) and extinction coefficient k (>= 0, of the fields' exp(-2 pi k z / lambda); 0 unless it is set) at a
   vacuum wavelength. */
typedef struct nicol_dispersion_v1 {
  uint32_t struct_size;
  uint32_t flags;
  const char* name;
  const char* meaning;      /* one line, with the source of the numbers */
  const nicol_parameter_v1* parameters;
  size_t parameter_count;
  void* user;
  int (*index)(void* user, const nicol_host_v1* host, const nicol_values_v1* values, double lambda_nm, double* n, double* k);
} nicol_dispersion_v1;

/* Relative radiance (>= 0) at a wavelength; a scene scales it so that `scale 1` gives Y = 1. */
typedef struct nicol_spectrum_v1 {
  uint32_t struct_size;
  uint32_t flags;
  const char* name;
  const char* meaning;
  const nicol_parameter_v1* parameters;
  size_t parameter_count;
  void* user;
  int (*radiance)(void* user, const nicol_host_v1* host, const nicol_values_v1* values, double lambda_nm, double* radiance);
} nicol_spectrum_v1;

/* A solid in scene units and POV-Ray's left-handed axes: either half-spaces by add_plane, or a closed mesh by add_point and add_face. */
typedef struct nicol_solid_v1 {
  uint32_t struct_size;
  uint32_t flags;
  const char* name;
  const char* meaning;
  const nicol_parameter_v1* parameters;
  size_t parameter_count;
  void* user;
  int (*make)(void* user, const nicol_host_v1* host, const nicol_values_v1* values);
} nicol_solid_v1;

/* Turns a file into scene text by set_text: `nicol render stone.gon --plugin goniometer`. */
typedef struct nicol_importer_v1 {
  uint32_t struct_size;
  uint32_t flags;
  const char* name;
  const char* meaning;
  const char* suffix;       /* ".gon"; lower case, with its dot */
  void* user;
  int (*read)(void* user, const nicol_host_v1* host, const char* path);
} nicol_importer_v1;

/* Row after row from the top left. Stokes radiance per nm in the receiver's frame: S1 > 0 horizontal, S2 > 0 at +45 deg, S3 > 0 right circular. */
typedef struct nicol_picture_v1 {
  uint32_t struct_size;
  int32_t width, height;
  uint32_t wavelength_count;
  const double* lambda_nm;
  const double* weight_nm;  /* the width that each wavelength stands for */
  const float* stokes;      /* [component 0..3][wavelength][row][column] */
  const float* rgb;         /* [row][column][3]: linear sRGB */
  const char* const* note_names;  /* scene, settings, device, errors */
  const char* const* note_values;
  uint32_t note_count;
} nicol_picture_v1;

/* Writes a picture to `path`, a name for the time being: the file gets its own when it is whole. `-o out.csv --plugin NAME`. */
typedef struct nicol_sink_v1 {
  uint32_t struct_size;
  uint32_t flags;
  const char* name;
  const char* meaning;
  const char* suffix;
  void* user;
  int (*write)(void* user, const nicol_host_v1* host, const nicol_picture_v1* picture, const char* path);
} nicol_sink_v1;

struct nicol_host_v1 {
  uint32_t struct_size;
  uint32_t version;         /* 1 */
  const char* nicol_version;
  /* in nicol_plugin_v1 */
  int (*add_dispersion)(const nicol_host_v1* host, const nicol_dispersion_v1* entry);
  int (*add_spectrum)(const nicol_host_v1* host, const nicol_spectrum_v1* entry);
  int (*add_solid)(const nicol_host_v1* host, const nicol_solid_v1* entry);
  int (*add_importer)(const nicol_host_v1* host, const nicol_importer_v1* entry);
  int (*add_sink)(const nicol_host_v1* host, const nicol_sink_v1* entry);
  /* everywhere: what went wrong */
  void (*set_message)(const nicol_host_v1* host, const char* text);
  /* in `make` of a solid: a file as the scene's #include finds it (NULL: there is none), planes with normal . p <= offset, corners of
     faces counter-clockwise seen from outside in right-handed axes (clockwise as left-handed axes are drawn) */
  const char* (*find_file)(const nicol_host_v1* host, const char* name);
  int (*add_plane)(const nicol_host_v1* host, const double normal[3], double offset);
  int (*add_point)(const nicol_host_v1* host, const double point[3]);
  int (*add_face)(const nicol_host_v1* host, const int32_t* corners, size_t count);
  /* in `read` of an importer */
  int (*set_text)(const nicol_host_v1* host, const char* text, size_t length);
};

#define NICOL_PLUGIN_ENTRY __attribute__((visibility("default")))
NICOL_PLUGIN_ENTRY int nicol_plugin_v1(const nicol_host_v1* host);

#ifdef __cplusplus
}
#endif

#endif
