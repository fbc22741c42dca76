// Parts of a picture joined to the whole, with what one run would say of it.
#pragma once
#include <string>
#include <vector>

#include "host/output/merge.hpp"

namespace nicol::engine {

struct MergedPicture {
  Frame frame;
  std::size_t parts = 0;
  std::vector<std::string> warnings;
  std::string missing;  // in words; "": nothing
};

// incomplete: joined even where something is missing; else the frame is empty then. Throws InputError.
MergedPicture merge_parts(const std::vector<std::string>& paths, bool incomplete, const std::string& command_line);

}  // namespace nicol::engine
