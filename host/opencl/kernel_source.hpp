// Kernel text: embedded in the program, or from the folder that NICOL_KERNEL_DIR names (for kernel developers).
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace nicol {

struct EmbeddedFile {
  std::string_view name;
  std::vector<std::string_view> chunks;
};

// Defined in the file that embed.cmake writes.
const std::vector<EmbeddedFile>& embedded_kernels();

// One kernel file by its bare name. Files missing from NICOL_KERNEL_DIR are the embedded ones. Throws
// DeviceError for a name that is nowhere.
std::string kernel_file(const std::string& name);

// `name` with every #include "..." replaced by its text, and #line directives, so that build logs name file
// and line. One source for clBuildProgram: -I with a space in the path and separate compilation both fail on
// some drivers. `fragments`: what stands in place of scene_fragments.h; "": nothing does.
std::string expand_includes(const std::string& name, const std::string& fragments = "");

}  // namespace nicol
