/* libnicol: scenes read, explained and rendered inside other programs. A C interface for C99 and C++; nicol.hpp is the C++ layer on it.

   Handles    are counted: what a function hands out holds one count, nicol_*_retain adds one, nicol_*_release takes one away and frees
              with the last. Releasing NULL does nothing. A scene keeps its context, a picture its scene. All are to be released before
              the program ends: OpenCL may be gone when static objects are.
   Pointers   that a handle's functions hand out stay valid as long as the handle; others as said at each function. Nothing that is
              handed in is kept beyond the call, but for the functions and `user` of nicol_context_options, which must last as long as the
              context, its scenes and its pictures.
   Texts      are UTF-8, ended by a zero, and never NULL when handed out.
   Structs    begin with struct_size, to be set to sizeof of the struct, the others to zero for what holds if nothing is said. A
              shorter struct, of a program built against an older header, is taken as if ended by zeros. A longer one must have
              zeros in what this library does not know, else it is refused with NICOL_ERROR_ARGUMENT. Structs that are filled: likewise,
              as much as fits, zeros behind.
   Errors     are statuses; nicol_last_error() has the words, of the last call on this thread that failed. Where a call fails, what it
              hands out is NULL or zero, except where said. NULL in place of a handle, an array or a place for a result, and values
              outside an enumeration, are NICOL_ERROR_ARGUMENT. No exception leaves this library, no function ends the program, and
              nothing is printed; an OpenCL driver may print what its compiler has to say.
   Threads    Scenes and pictures do not change once they are handed out: any number of threads may read them. A context may be used by
              several threads. Its renderings take turns; reading scenes does not wait for them. Distinct contexts do not wait for each
              other, except where kernels are compiled and saved.
   Callbacks  run on the thread that made the call, before it returns, so several threads that share a context may be in the same
              callback at once. A callback may call anything but nicol_render, nicol_scene_load_*, nicol_merge and
              nicol_load_plugin, which are refused with NICOL_ERROR_ARGUMENT there. Where one answers an int, 0 means go on and anything else stop. A C++ exception that leaves
              a callback stops the call, which answers NICOL_ERROR_CALLBACK with its words.
   Frames     Pictures are stored row after row, from the top and from the left, as the receiver sees them. Stokes vectors are
              radiance per nm in the scene's own unit, in the receiver's frame, x to the right and y up, light running towards the eye
              (kernels/README.md, "Conventions"): S1 > 0 horizontal, S2 > 0 at +45 degrees counter-clockwise from x, S3 > 0 right
              circular: clockwise in time for the receiver. Wavelengths are vacuum wavelengths in nm, ascending. */
#ifndef NICOL_H
#define NICOL_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define NICOL_API __attribute__((visibility("default")))
#else
#define NICOL_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Rises when programs built before must be built anew. Functions, values and members of structs are added without that. */
#define NICOL_ABI_VERSION 1
NICOL_API uint32_t nicol_abi_version(void);
NICOL_API const char* nicol_version(void); /* "0.1.0"; lasts */

typedef int32_t nicol_status;
enum {
  NICOL_OK = 0,
  NICOL_CANCELLED = 1,         /* a callback said stop; what there is so far is handed out */
  NICOL_ERROR_ARGUMENT = 2,    /* what was asked makes no sense */
  NICOL_ERROR_SCENE = 3,       /* the scene has errors: see its diagnostics */
  NICOL_ERROR_DEVICE = 4,      /* no OpenCL device, none of that name, or it failed */
  NICOL_ERROR_INPUT = 5,       /* a file that cannot be read, or parts that do not fit each other */
  NICOL_ERROR_OUTPUT = 6,      /* a file that cannot be written */
  NICOL_ERROR_MEMORY = 7,      /* memory ran out; a picture larger than all of the machine's is NICOL_ERROR_ARGUMENT */
  NICOL_ERROR_PLUGIN = 8,      /* a plugin that cannot be loaded, or that failed */
  NICOL_ERROR_CALLBACK = 9,    /* an exception left a callback */
  NICOL_ERROR_UNAVAILABLE = 10, /* this picture does not have it */
  NICOL_ERROR_INTERNAL = 11    /* an error in this library */
};

/* What a status means, in general; "unknown status" for a number that is none. Lasts. */
NICOL_API const char* nicol_status_text(nicol_status status);
/* Of the last call on this thread that did not answer NICOL_OK; "" if there was none. Valid until the next such call on this thread. */
NICOL_API const char* nicol_last_error(void);

/* ---- Devices ---- */

typedef struct nicol_device_info {
  uint32_t struct_size;
  int32_t index;            /* as nicol_context_options::device names it */
  char name[128];           /* cut where they are longer */
  char platform[128];
  char version[128];        /* of OpenCL */
  char driver[128];
  int32_t is_cpu, is_gpu, has_fp64; /* 1 or 0 */
  int32_t compute_units;
  uint64_t memory_bytes;
} nicol_device_info;

/* How many OpenCL devices this machine has; none is no error. */
NICOL_API nicol_status nicol_device_count(size_t* count);
/* index: 0 to count - 1. Fills *info. */
NICOL_API nicol_status nicol_device_get(size_t index, nicol_device_info* info);

/* ---- Contexts: a device, and where messages go ---- */

typedef struct nicol_context nicol_context;

typedef int32_t nicol_severity;
enum { NICOL_NOTE = 0, NICOL_WARNING = 1, NICOL_ERROR = 2 };

/* text: valid during the call. What scenes' diagnostics say is not told here, what #debug prints is. */
typedef void (*nicol_log_callback)(void* user, nicol_severity severity, const char* text);

typedef struct nicol_context_options {
  uint32_t struct_size;
  uint32_t library_path_count;
  const char* device;                /* index, or a part of the name in any case; several with commas, or "all": they share the work;
                                        NULL or "": a GPU if there is one, else the CPU */
  const char* const* library_paths;  /* folders where include files and gem cuts are looked for, before nicol's own */
  nicol_log_callback log;            /* may be NULL */
  void* user;                        /* handed to log */
} nicol_context_options;

/* options: may be NULL. A device that is named is opened at once, the default one when first needed: scenes are read and parts merged
   where there is no device. */
NICOL_API nicol_status nicol_context_create(const nicol_context_options* options, nicol_context** context);
NICOL_API nicol_context* nicol_context_retain(nicol_context* context); /* answers its argument */
NICOL_API void nicol_context_release(nicol_context* context);
/* The device that this context renders on, or the first of them, opened if it is not yet. */
NICOL_API nicol_status nicol_context_device(nicol_context* context, nicol_device_info* info);

/* Loads a plugin (nicol_plugin.h): its code runs in this process, and stays until the end. path: a file, with a '/' or ending in .so, or a name
   that is looked for in NICOL_PLUGIN_PATH, the context's library paths and nicol's own folder. What it brings is for the scenes that this
   context reads afterwards; formats that it writes are there for every picture. NICOL_ERROR_PLUGIN. */
NICOL_API nicol_status nicol_load_plugin(nicol_context* context, const char* path);

/* ---- Scenes ---- */

typedef struct nicol_scene nicol_scene;

/* The text of an include file, to be given by nicol_include_set_text. */
typedef struct nicol_include nicol_include;
/* Asked for each #include before any file is looked for; name: as the scene says it. Without nicol_include_set_text files are looked for. */
typedef int (*nicol_include_callback)(void* user, const char* name, nicol_include* include);
/* In an include callback only. text: `size` bytes, copied; may be NULL if size is 0. */
NICOL_API nicol_status nicol_include_set_text(nicol_include* include, const char* text, size_t size);

typedef int32_t nicol_switch;
enum { NICOL_AS_IN_SCENE = 0, NICOL_ON = 1, NICOL_OFF = 2 };

typedef struct nicol_scene_options {
  uint32_t struct_size;
  int32_t width, height;              /* of the picture, pixels; 0: 512 */
  uint32_t library_path_count;
  const char* const* library_paths;   /* folders, before those of the context */
  size_t declare_count;
  const char* const* declare_names;   /* as #declare NAME = VALUE ahead of the scene */
  const double* declare_values;
  size_t wavelength_count;            /* 0: the scene's */
  const double* wavelengths_nm;       /* in any order, no two alike */
  int32_t samples;                    /* per pixel; 0: the scene's */
  int32_t max_trace_level;            /* faces on a path; 0: the scene's */
  double error;                       /* relative, 0 < error < 1: settings that keep the picture to it are chosen; 0: as the scene says */
  double sample_error;                /* relative, 0 < e < 1: of pixel sampling alone; 0: as the scene says */
  double adc_bailout;                 /* weight below which a path ends; 0: the scene's */
  nicol_switch polarization;
  int32_t frame_number;               /* of an animation, with the next three as POV-Ray has them; all 0: no animation */
  int32_t initial_frame, final_frame;
  double clock, clock_delta, initial_clock, final_clock;
  nicol_include_callback include;     /* may be NULL */
  void* user;                         /* handed to include */
} nicol_scene_options;

/* Reads a scene: its text, its meaning, its geometry, and which effects it calls for. options: may be NULL. NICOL_OK: it can be rendered.
   NICOL_ERROR_SCENE: the text was read but has errors; *scene is a handle all the same, which tells them by its diagnostics. A file
   that cannot be read is NICOL_ERROR_INPUT, include() saying stop NICOL_CANCELLED, both without a handle. */
NICOL_API nicol_status nicol_scene_load_file(nicol_context* context, const char* path, const nicol_scene_options* options, nicol_scene** scene);
/* The same of `size` bytes of text. name: that messages call it by; files are looked for in its folder too, as if it lay there. */
NICOL_API nicol_status nicol_scene_load_text(nicol_context* context, const char* name, const char* text, size_t size,
                                             const nicol_scene_options* options, nicol_scene** scene);
NICOL_API nicol_scene* nicol_scene_retain(nicol_scene* scene); /* answers its argument */
NICOL_API void nicol_scene_release(nicol_scene* scene);

NICOL_API int nicol_scene_is_whole(const nicol_scene* scene); /* 1: without errors, can be rendered; 0: not, or NULL */

typedef struct nicol_diagnostic {
  uint32_t struct_size;
  nicol_severity severity;
  const char* file;        /* the scene's own where no place can be told */
  uint32_t line, column;   /* from 1; column in bytes. 0, 0: of the scene as a whole */
  const char* message;
  const char* text;        /* all of it, on several lines: place, source line, caret, the macros that led there, hints */
} nicol_diagnostic;

/* Errors, warnings and notes in the order they were found. Counts are 0 for NULL. */
NICOL_API size_t nicol_scene_diagnostic_count(const nicol_scene* scene);
NICOL_API nicol_status nicol_scene_diagnostic(const nicol_scene* scene, size_t index, nicol_diagnostic* diagnostic);

/* The files that reading opened, and the names of texts handed in, the scene's own first. */
NICOL_API size_t nicol_scene_file_count(const nicol_scene* scene);
NICOL_API nicol_status nicol_scene_file(const nicol_scene* scene, size_t index, const char** path);

typedef struct nicol_feature {
  uint32_t struct_size;
  int32_t on;            /* 1: the scene calls for it; 0: it is left out of the kernel */
  const char* name;
  const char* meaning;
  const char* reason;    /* what calls for it, or why it is left out */
} nicol_feature;

/* Every effect that a kernel can have. None (0) of a scene with errors. */
NICOL_API size_t nicol_scene_feature_count(const nicol_scene* scene);
NICOL_API nicol_status nicol_scene_feature(const nicol_scene* scene, size_t index, nicol_feature* feature);
/* All of that as `nicol explain` prints it. NICOL_ERROR_SCENE of a scene with errors. */
NICOL_API nicol_status nicol_scene_explanation(const nicol_scene* scene, const char** text);

/* The size of the picture, pixels. */
NICOL_API nicol_status nicol_scene_size(const nicol_scene* scene, int32_t* width, int32_t* height);
/* What is rendered, before settings for an error are chosen: wavelengths in nm. NICOL_ERROR_SCENE of a scene with errors. */
NICOL_API nicol_status nicol_scene_wavelengths(const nicol_scene* scene, const double** wavelengths_nm, size_t* count);

/* ---- Rendering ---- */

typedef struct nicol_picture nicol_picture;

/* Pixels whose values have changed. All pointers are valid during the call. */
typedef struct nicol_tile {
  uint32_t struct_size;
  int32_t width, height;          /* of the whole picture */
  uint32_t reserved;
  size_t pixel_count;
  const int32_t* pixels;          /* [pixel_count]: row * width + column */
  size_t wavelength_count;
  const double* wavelengths_nm;   /* [wavelength_count] */
  const float* stokes;            /* [component 0..3][wavelength][pixel_count] */
  const float* linear_srgb;       /* [pixel_count][red, green, blue], times the scene's exposure */
} nicol_tile;

/* fraction: 0 to 1; seconds: since rendering began, and about how many are left. */
typedef int (*nicol_progress_callback)(void* user, double fraction, double seconds, double seconds_left);
typedef int (*nicol_tile_callback)(void* user, const nicol_tile* tile);
typedef int (*nicol_cancel_callback)(void* user);

typedef int32_t nicol_precision;
enum { NICOL_FLOAT = 0, NICOL_DOUBLE = 1 };

typedef struct nicol_render_options {
  uint32_t struct_size;
  nicol_precision precision;       /* of the kernel; double where an error asks for it, whatever stands here */
  int32_t lanes;                   /* work-item's vector width: 1, 4, 8 or 16; 0: the device's own */
  int32_t generic;                 /* 1: one kernel for every scene instead of one made for this */
  int32_t no_cache;                /* 1: kernels are neither loaded from nicol's cache on the disk nor kept there; one that this context has
                                      built before is taken again, and drivers have caches of their own */
  int32_t resume;                  /* 1: goes on from the tiles in `journal` */
  const char* journal;             /* file that keeps finished tiles of a rendering of more than a few seconds; NULL: none. It is
                                      removed when the picture is whole */
  int32_t want_error_bound;        /* 1: the planes NICOL_PLANE_ERROR_*; costs some time */
  int32_t want_error_budget;       /* 1: nicol_picture_budget_*; costs some time */
  int32_t part, part_count;        /* the share `part` of part_count (1 <= part <= part_count) of the pixels; 0, 0: all */
  int32_t first_row, row_count;    /* a window, from 0; row_count 0: all rows */
  int32_t first_column, column_count;
  double first_wavelength_nm, last_wavelength_nm; /* those of the scene's wavelengths in this range; 0, 0: all. Only a picture without a
                                      part, pixels or wavelengths left out can keep an error, or have a bound or a budget: else
                                      NICOL_ERROR_ARGUMENT. Part 1 of 1 is a part, to be merged; a window of all pixels is none */
  nicol_progress_callback progress;   /* may be NULL, as the next two: called between tiles */
  nicol_tile_callback tile;
  nicol_cancel_callback cancel;       /* asked then too, and between stages */
  void* user;                         /* handed to these three */
} nicol_render_options;

/* Renders on the device of the scene's context, with the same bits as `nicol render`. options: may be NULL. NICOL_CANCELLED: a callback said
   stop; *picture is there as far as it got, unless that was before a whole row was done, or in a part: then NULL. NICOL_ERROR_CALLBACK: likewise.
   NICOL_ERROR_SCENE: the scene has errors. Where the scene asks for an error to be kept, wavelengths may be added, for which the scene
   is read once more (include files that a callback gave are remembered). */
NICOL_API nicol_status nicol_render(const nicol_scene* scene, const nicol_render_options* options, nicol_picture** picture);

typedef struct nicol_merge_options {
  uint32_t struct_size;
  int32_t incomplete;   /* 1: what is missing does not matter; 0: it is NICOL_ERROR_INPUT, with its names */
} nicol_merge_options;

/* Joins parts of a picture, written as .exr by nicol_picture_write or `nicol render --part`, to the bits of one run. options: may be NULL. */
NICOL_API nicol_status nicol_merge(nicol_context* context, const char* const* paths, size_t count, const nicol_merge_options* options,
                                   nicol_picture** picture);

/* ---- Pictures ---- */

NICOL_API nicol_picture* nicol_picture_retain(nicol_picture* picture); /* answers its argument */
NICOL_API void nicol_picture_release(nicol_picture* picture);

/* Pixels. */
NICOL_API nicol_status nicol_picture_size(const nicol_picture* picture, int32_t* width, int32_t* height);
/* wavelengths_nm, and the width in nm that each stands for in a sum over the spectrum (may be NULL). */
NICOL_API nicol_status nicol_picture_wavelengths(const nicol_picture* picture, const double** wavelengths_nm, const double** widths_nm,
                                                 size_t* count);

/* The film itself, not a copy: [component 0..3][wavelength][row][column]. What was not rendered is zero. */
NICOL_API nicol_status nicol_picture_stokes(const nicol_picture* picture, const float** stokes);
/* CIE 1931 X, Y, Z: [component][row][column], by the 2 degree observer, Y = 1 for a light of brightness 1. */
NICOL_API nicol_status nicol_picture_xyz(const nicol_picture* picture, const float** xyz);
/* Linear sRGB (IEC 61966-2-1), red, green, blue, times the scene's exposure, not clipped: [component][row][column]. */
NICOL_API nicol_status nicol_picture_linear_srgb(const nicol_picture* picture, const float** rgb);

typedef int32_t nicol_plane;
enum {
  NICOL_PLANE_COVERAGE = 0,       /* 1 where the picture was rendered, 0 where not; between: some of the wavelengths */
  NICOL_PLANE_SAMPLES = 1,        /* that the pixel got */
  NICOL_PLANE_CUT_OFF = 2,        /* weight of the paths cut off, relative to a full path */
  NICOL_PLANE_SAMPLE_ERROR = 3,   /* estimated error of pixel sampling: RMS over wavelengths of the Stokes vector's, radiance per nm */
  NICOL_PLANE_ERROR_CUT_OFF = 4,  /* want_error_bound: bound of what is cut off, radiance per nm */
  NICOL_PLANE_ERROR_SAMPLING = 5, /* likewise: estimate of sampling, */
  NICOL_PLANE_ERROR_ROUNDING = 6, /* of rounding (with want_error_budget, else 0), */
  NICOL_PLANE_ERROR_TOTAL = 7     /* and their sum */
};

/* [row][column]. NICOL_ERROR_UNAVAILABLE where the picture does not have the plane. */
NICOL_API nicol_status nicol_picture_plane(const nicol_picture* picture, nicol_plane plane, const float** values);

typedef struct nicol_report {
  uint32_t struct_size;
  int32_t lanes;                  /* vector width of the kernel */
  nicol_precision precision;
  int32_t interrupted;            /* 1: not finished */
  const char* device;
  double seconds;                 /* of rendering, and from the start to the first tile */
  double seconds_to_first_tile;
  double build_seconds;           /* of building the kernel or loading it */
  int32_t kernel_cached;          /* 1: loaded */
  int32_t passes;                 /* of samples */
  uint64_t segments;              /* ways between two faces that were traced, for each wavelength */
  uint64_t nan_count;             /* paths left out: their light was not a number */
  uint64_t energy_count;          /* faces that gave out more light than they got */
  uint64_t stack_count;           /* paths with more branches than the stack holds, counted as cut off */
  uint64_t stokes_count;          /* pixels polarized by more than 100 % */
  uint64_t precise_count;         /* waves that needed the precise solver */
  uint64_t tiles, tiles_found;    /* rendered; taken from the journal */
  double samples_mean;            /* per pixel */
  double sample_error;            /* estimate, relative to mean_radiance; NaN: not known */
  int32_t sample_error_kept;      /* 1: as asked for, or none was asked for */
  int32_t reserved;
  double mean_radiance;           /* of S0, per nm */
  double cut_off_mean, cut_off_worst; /* over pixels, of NICOL_PLANE_CUT_OFF */
} nicol_report;

/* How it was rendered. NICOL_ERROR_UNAVAILABLE of a merged picture. */
NICOL_API nicol_status nicol_picture_report(const nicol_picture* picture, nicol_report* report);

typedef struct nicol_budget_line {
  uint32_t struct_size;
  uint32_t reserved;
  const char* source;    /* "cut-off", "spectral step", ... */
  double rms;            /* over pixels, relative to the mean radiance (spectral step: to the mean Y); NaN: not known, detail says why */
  const char* detail;
  const char* price;     /* what less of it costs */
  double seconds;        /* that it has taken, to keep it as small and to find out */
} nicol_budget_line;

/* The error budget, if it was asked for: 0 lines if not. */
NICOL_API size_t nicol_picture_budget_count(const nicol_picture* picture);
NICOL_API nicol_status nicol_picture_budget_line(const nicol_picture* picture, size_t index, nicol_budget_line* line);
/* RMS of all sources that are known, as independent, relative. NICOL_ERROR_UNAVAILABLE without a budget. */
NICOL_API nicol_status nicol_picture_budget_rms(const nicol_picture* picture, double* rms);

typedef struct nicol_chosen {
  uint32_t struct_size;
  int32_t kept;          /* 1: the error that was asked for is kept, as far as is known */
  double error;          /* that was asked for, relative */
  const char* text;      /* what was chosen */
  const char* reason;    /* "", or why it is not kept */
  double seconds;        /* that choosing took */
} nicol_chosen;

/* The settings that were chosen for an error. NICOL_ERROR_UNAVAILABLE where none was asked for. */
NICOL_API nicol_status nicol_picture_chosen(const nicol_picture* picture, nicol_chosen* chosen);

/* What a file's header tells: scene, settings, device, time, error budget. */
NICOL_API size_t nicol_picture_note_count(const nicol_picture* picture);
NICOL_API nicol_status nicol_picture_note(const nicol_picture* picture, size_t index, const char** key, const char** text);

/* Writes the picture, format by the suffix: .exr (spectral, Stokes, planes) or .png (colours). The file appears whole or not at all.
   NICOL_ERROR_OUTPUT with the path. A picture of some wavelengths or of a dealt part has only .exr: NICOL_ERROR_ARGUMENT. */
NICOL_API nicol_status nicol_picture_write(const nicol_picture* picture, const char* path);
/* The same of its error bound, as a picture: nicol render --error-map. NICOL_ERROR_UNAVAILABLE without want_error_bound. */
NICOL_API nicol_status nicol_picture_write_error_map(const nicol_picture* picture, const char* path);

#ifdef __cplusplus
}
#endif
#endif
