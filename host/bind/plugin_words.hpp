// plugin { "NAME" parameter value ... }: what a scene asks of a plugin, before it is known what that is.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host/bind/context.hpp"
#include "host/plugins/parameters.hpp"

namespace nicol {

// The string that stands first in the block; nullopt, and told, if there is none.
std::optional<std::string> plugin_name(Context& context, const sdl::Block& block);

// What the block says of these parameters, what it does not say as the plugin has it. Unknown words are named with the nearest
// known one; a missing value, one of the wrong kind or outside [least, most], and one said twice are errors with their places.
// nullopt after an error.
std::optional<plugins::Values> read_parameters(Context& context, const sdl::Block& block, const std::string& name,
                                               const std::vector<plugins::Parameter>& parameters);

// A file as `#include` finds it: the working directory, the library folders, the scene's own folder; "" if there is none.
// What is found is listed in BindOptions::files_read.
std::string find_file(const Context& context, const std::string& name);

}  // namespace nicol
