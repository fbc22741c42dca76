// The effects that a scene has and that can be left out of it, to see what each is worth.
#pragma once
#include <string>
#include <vector>

#include "host/scene.hpp"

namespace nicol {

struct Effect {
  std::string name;     // one word
  std::string without;  // what stands in its place ("refractive indices as at 580 nm")
};

// Those that the scene calls for, in a fixed order. Only media that a solid or the surroundings have count.
std::vector<Effect> effects_of(const Scene& scene);

// Names of those that light owes to a way through the medium, or to the polarizer. Not among them: coherence, for which two
// waves must stay together, and conical_rays, for which a wave normal must meet a binormal.
std::vector<std::string> effects_of_medium(const Scene& scene, const Medium& medium);
std::vector<std::string> effects_of_polarizer(const Scene& scene, const Polarizer& polarizer);

// Of all effects that some scene can have, in the same order.
const std::vector<std::string>& effect_names();

// The scene without one of them; geometry built for the scene stays valid, features must be decided anew.
// Throws std::invalid_argument for a name that effects_of does not list.
Scene without_effect(const Scene& scene, const std::string& name);

}  // namespace nicol
