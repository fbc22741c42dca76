// Small pictures of scenes given as text; the test's own fragments lie in plugins/.
#pragma once
#include <memory>
#include <string>

#include "host/engine/loaded_scene.hpp"
#include "host/opencl/fragment_check.hpp"

namespace nicol::test {

// What a scene comes to: `loaded` is null after an error, told in `errors`.
struct Read {
  std::unique_ptr<engine::LoadedScene> loaded;
  std::string errors;
};
Read read(const std::string& text, const std::string& wavelengths = "450,589,650", int size = 8);

// Its picture. Throws what does not load, and FragmentError.
Frame shoot(const std::string& text, bool real_double = true, const std::string& wavelengths = "450,589,650", int size = 8,
            int lanes = 0);

// The message of the FragmentError that this scene ends with; "" if there is none.
std::string refusal(const std::string& text, bool real_double = false);

// Largest difference of any Stokes component over the largest S0.
double difference(const Frame& a, const Frame& b);

// S0 of the pixel in the middle at wavelength `w`.
double centre(const Frame& frame, std::size_t w = 0, int component = 0);

// A folder of this test that is there and empty.
std::string new_folder(const std::string& name);
void write(const std::string& file, const std::string& text);

}  // namespace nicol::test
