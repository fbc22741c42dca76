// What all of bind shares: the scene being made, where complaints go, and the budget against scenes
// that name one thing 2^40 times.
#pragma once
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>

#include "host/bind/bind.hpp"

namespace nicol {

struct RawObject;      // parts.hpp
struct BoundInterior;  // parts.hpp
struct Manifest;       // host/fragments/manifest.hpp

// Thrown once the budget is spent or too much has been complained about; bind() catches it.
struct GiveUp {};

struct Limits {
  std::size_t objects = 1'000'000;     // after expansion of shared blocks
  std::size_t transforms = 4'000'000;  // of all objects together
  std::size_t steps = 150'000'000;  // about what it costs to read: 1 for a word or number,
  std::size_t block_steps = 64;     // this for a block,
  std::size_t visit_steps = 8;      // this for an object named again
  std::size_t complaints = 200;
  int depth = 300;  // unions in unions, identifiers in identifiers
  std::size_t wavelengths = 1024;
};

class Context {
 public:
  Context(Scene& scene_made, const BindOptions& wanted, sdl::Diagnostics& diagnostics)
      : scene(scene_made), options(wanted), diagnostics_(diagnostics) {}

  Scene& scene;
  const BindOptions& options;
  const Limits limits;
  std::unordered_map<const sdl::Block*, std::shared_ptr<const BoundInterior>> interior_of_block;
  std::unordered_map<const sdl::Block*, std::shared_ptr<const RawObject>> object_of_block;
  // Of a block in one hand and one orientation; and of the values that this comes to.
  std::map<std::tuple<const sdl::Block*, bool, std::array<double, 9>>, int> medium_of_placed;
  std::map<std::vector<double>, int> medium_of_values;
  std::map<std::string, std::shared_ptr<const Manifest>> manifests;  // of plugins' fragments, by file
  std::size_t transform_count = 0;

  // The same complaint about the same place (a shared block) is made once.
  void error(Location where, const std::string& message);
  void warning(Location where, const std::string& message);
  void note(Location where, const std::string& message);
  // Only the first time that `key` comes.
  void warn_once(const std::string& key, Location where, const std::string& message);
  void note_once(const std::string& key, Location where, const std::string& message);
  std::size_t error_count() const { return error_count_; }

  // No error so far, neither here nor while reading the text.
  bool all_well() const { return !diagnostics_.failed(); }

  // Counts items looked at.
  void step(Location where, std::size_t count = 1);

  // Counts how deep blocks lie in blocks, through identifiers too.
  class Depth {
   public:
    Depth(Context& context, Location where);
    ~Depth() { --context_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    Context& context_;
  };

 private:
  bool is_new(Location where, const std::string& message);

  sdl::Diagnostics& diagnostics_;
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::string>>
      said_;
  std::set<std::string> keys_;
  std::size_t steps_ = 0;
  int depth_ = 0;
  std::size_t error_count_ = 0;
};

// A number as a person would write it.
std::string to_text(double number);

}  // namespace nicol
