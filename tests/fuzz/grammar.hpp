// Scenes that are right as a text, made of bytes: what they say about solids and contacts is still anything.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace nicol::fuzz {

// A few solids, cut from one another or not, and sheets; many numbers are alike, so that faces coincide.
std::string scene_of_bytes(const std::uint8_t* data, std::size_t size);

}  // namespace nicol::fuzz
