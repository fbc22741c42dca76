// What the host packs and the kernels read: records of ints and of scalars, by these strides and slots.
// Positions are in mm: those of a cell's faces, edges and rings relative to the cell's centre; centres and
// the camera relative to the scene's origin, which the host chooses. Normals are unit and point outward.
// Tables hold one row of `lambda_stride` values per quantity; rows are named by their index.
#ifndef NICOL_ABI_H
#define NICOL_ABI_H

enum {
  ABI_VERSION = 1,
  // header: the first ints of the scene
  HEADER_FEATURES = 0, HEADER_WIDTH, HEADER_HEIGHT, HEADER_LAMBDA_COUNT, HEADER_LAMBDA_STRIDE,
  HEADER_MAX_TRACE_LEVEL, HEADER_CAMERA_CELL, HEADER_CAMERA_POLARIZER, HEADER_SKY_ROW,
  HEADER_CELL_COUNT, HEADER_SHEET_COUNT, HEADER_PATCH_COUNT, HEADER_MEDIUM_COUNT,
  HEADER_CELLS_AT, HEADER_FACES_AT, HEADER_PATCHES_AT, HEADER_SHEETS_AT, HEADER_LIGHTS_AT,
  HEADER_POLARIZERS_AT, HEADER_MEDIA_AT, HEADER_LISTS_AT,          // offsets into the ints
  HEADER_CAMERA_REALS, HEADER_CELL_REALS, HEADER_FACE_REALS, HEADER_PATCH_REALS, HEADER_EDGE_REALS,
  HEADER_SHEET_REALS, HEADER_POLARIZER_REALS, HEADER_SETTING_REALS, // offsets into the scalars
  HEADER_DELTA_ROW,   // row of N2^2 - N1^2 (MEDIUM_ROW_N) for media (1, 2): DELTA_ROW + medium1 * MEDIUM_COUNT + medium2
  HEADER_WAVELENGTH_ROW,  // rows of wavelengths: 1/lambda in 1/mm, then the width of the bin over lambda
  HEADER_CONICAL_RAYS,    // azimuths that sample the cone at a binormal, per sample; 0: none
  HEADER_FRAGMENTS_AT, HEADER_FRAGMENT_REALS,  // uses of plugins' fragments: offsets into the ints and into the scalars
  HEADER_SIZE = 40,

  // cell: ints; lists of children and sheets lie in the lists section
  CELL_FIRST_FACE = 0, CELL_FACE_COUNT, CELL_FIRST_PATCH, CELL_PATCH_COUNT, CELL_FIRST_CHILD,
  CELL_CHILD_COUNT, CELL_FIRST_SHEET, CELL_SHEET_COUNT, CELL_MEDIUM, CELL_PARENT, CELL_INTS,
  // cell: scalars centre x y z, radius around the centre that holds the whole cell
  CELL_CENTRE = 0, CELL_RADIUS = 3, CELL_REALS = 4,
  // face: ints (light: an opaque light for rays from outside, -1: none; surface: a fragment's use, -1: none); scalars normal x y z,
  // offset
  FACE_LIGHT = 0, FACE_SURFACE, FACE_INTS,
  FACE_REALS = 4,
  // patch on a face of CELL; TWIN: the patch of the other cell (seam, gap, contact)
  PATCH_BEHIND = 0, PATCH_CELL, PATCH_FACE, PATCH_TWIN, PATCH_SHEET, PATCH_LIGHT,
  PATCH_FIRST_EDGE, PATCH_EDGE_COUNT, PATCH_HAS_DISC, PATCH_INTS,
  PATCH_DISC_CENTRE = 0, PATCH_RADIUS2 = 3, PATCH_HOLE2 = 4, PATCH_REALS = 5,
  BEHIND_SEAM = 0, BEHIND_CELL_GAP, BEHIND_CELL_CONTACT, BEHIND_LIGHT, BEHIND_POLARIZER,
  // edge: scalars normal x y z, offset; inside is normal . p <= offset
  EDGE_REALS = 4,
  // sheet; TOUCHES: a polarizer with patches on some cell
  SHEET_LIGHT = 0, SHEET_POLARIZER, SHEET_TOUCHES, SHEET_FIRST_EDGE, SHEET_EDGE_COUNT, SHEET_HAS_DISC, SHEET_INTS,
  SHEET_CENTRE = 0, SHEET_PLANE = 3, SHEET_DISC_CENTRE = 7, SHEET_RADIUS2 = 10, SHEET_HOLE2 = 11,
  SHEET_REALS = 12,
  // light
  LIGHT_ROW = 0, LIGHT_POLARIZER, LIGHT_ONE_SIDED, LIGHT_INTS,
  // polarizer
  POLARIZER_KIND = 0, POLARIZER_ROW, POLARIZER_USE, POLARIZER_INTS,
  POLARIZER_AXIS = 0, POLARIZER_NORMAL = 3, POLARIZER_REALS = 6,
  POLARIZER_IDEAL = 0, POLARIZER_IDEAL_ABSORBING, POLARIZER_CALCITE, POLARIZER_FRAGMENT,
  // rows of a calcite polarizer from POLARIZER_ROW on
  POLARIZER_ROW_N_O = 0, POLARIZER_ROW_N_E, POLARIZER_ROWS,
  // use of a fragment: which of the scene's fragments (scene_fragments.h), where its parameters begin among those of all uses, whether
  // it reflects (elements)
  FRAGMENT_INDEX = 0, FRAGMENT_FIRST, FRAGMENT_REFLECTS, FRAGMENT_INTS,
  // medium: first row, flags, kind of waves (WAVES_* of waves.h), optically active crystal
  MEDIUM_ROW = 0, MEDIUM_ABSORBS, MEDIUM_ROTATES, MEDIUM_WAVES, MEDIUM_ACTIVE, MEDIUM_INTS,
  // rows of a medium from MEDIUM_ROW on. N: index; of crystals the one that the others are counted from
  // (uniaxial: ordinary; else sqrt(3/tr eta)). Rotation of isotropic media in turns per mm as hi + lo (two scalars keep
  // the phase of 1e5 turns); extinction coefficient k
  MEDIUM_ROW_N = 0, MEDIUM_ROW_K, MEDIUM_ROW_ABSORB_PER_MM, MEDIUM_ROW_TURNS_HI, MEDIUM_ROW_TURNS_LO,
  MEDIUM_ROWS,
  // crystals: symmetric tensors as xx yy zz yz zx xy in the world
  CRYSTAL_ROW_IM_EPS = MEDIUM_ROWS,
  // uniaxial: optic axis x y z, n_e^2, n_e^2 - n_o^2, 1/n_e^2 - 1/n_o^2
  UNIAXIAL_ROW_AXIS = CRYSTAL_ROW_IM_EPS + 6, UNIAXIAL_ROW_EPS_E = UNIAXIAL_ROW_AXIS + 3, UNIAXIAL_ROW_D_EPS,
  UNIAXIAL_ROW_D_ETA,
  CHIRAL_ROW_KAPPA = CRYSTAL_ROW_IM_EPS + 6,  // isotropic, active: half the difference of the circular waves' indices
  // general: n2bar eta - 1, the gyration term, zeta (waves.h)
  GENERAL_ROW_ATIL = CRYSTAL_ROW_IM_EPS + 6, GENERAL_ROW_GQ = GENERAL_ROW_ATIL + 6, GENERAL_ROW_ZETA = GENERAL_ROW_GQ + 6,
  // camera scalars; FOOTPRINT: size of a pixel in mm at the camera, and what it grows by per mm of distance
  CAMERA_LOCATION = 0, CAMERA_DIRECTION = 3, CAMERA_RIGHT = 6, CAMERA_UP = 9, CAMERA_FOOTPRINT = 12, CAMERA_REALS = 14,
  // setting scalars; CONICAL_SPREAD: half the angle of the bundle that a ray stands for, rad
  SETTING_ADC_BAILOUT = 0, SETTING_CONICAL_SPREAD, SETTING_REALS,

  // what a work-item writes, sums over its samples, LANES scalars each: S0, S1, S2, S3, cut-off weight; the square of the
  // Stokes vector's length; S0, its sign changing from pair to pair of samples (0, 12, 34, ...); the signature (path.h) where all samples have the same, else -1
  OUT_STOKES = 0, OUT_CUT_OFF = 4, OUT_SQUARE = 5, OUT_HALVES = 6, OUT_SIGNATURE = 7, OUT_COMPONENTS = 8,
  // counters
  COUNT_NAN = 0, COUNT_ENERGY, COUNT_STACK, COUNT_STOKES, COUNT_FALLBACK, COUNT_SEGMENTS, COUNTERS
};

#endif
