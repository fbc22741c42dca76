// Pictures of one loaded scene under any feature mask, and how far two of them are apart.
#pragma once
#include <memory>
#include <string>

#include "host/engine/loaded_scene.hpp"

namespace nicol::test {

struct Setup {
  std::unique_ptr<engine::LoadedScene> loaded;
  std::shared_ptr<Device> device;
};
// Throws if the scene of this folder does not load.
Setup load(const std::string& file);

// A scene of scenes/, at these wavelengths ("": its own).
Setup load_gallery(const std::string& file, const std::string& wavelengths);

struct Picture {
  Frame frame;
  RenderReport report;
};
Picture take(const Setup& setup, std::uint32_t features, const KernelOptions& kernel, int size = 16);

// Largest difference of any Stokes component over the largest S0.
double difference(const Picture& a, const Picture& b);

}  // namespace nicol::test
