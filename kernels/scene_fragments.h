// The fragments that a scene names. The host puts their text in place of this file (host/fragments/kernel_text.hpp), with
// FRAGMENTS_HERE 1 and run_element and run_surface going to fragment number `fragment`. Here there is none.
#ifndef NICOL_SCENE_FRAGMENTS_H
#define NICOL_SCENE_FRAGMENTS_H
#include "fragment.h"

#define FRAGMENTS_HERE 0
#define run_element(fragment, in, parameter, out) ((void)(fragment), (void)(in), (void)(parameter), (void)(out))
#define run_surface(fragment, in, parameter, out) ((void)(fragment), (void)(in), (void)(parameter), (void)(out))

#endif
