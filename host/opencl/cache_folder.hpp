// Where nicol keeps what it may lose: compiled kernels, PoCL's own cache.
#pragma once
#include <string>

namespace nicol {

// ${XDG_CACHE_HOME:-~/.cache}/nicol, made if missing; if that cannot be written, a folder of this user's
// under the temporary folder; "" if neither can.
std::string cache_folder();

// True if files can be made in `folder`, which is made if missing.
bool is_writable_folder(const std::string& folder);

// PoCL refuses to start (clGetDeviceIDs gives -1) where it cannot write its cache: points POCL_CACHE_DIR at a
// folder that can be written. Call before the first OpenCL call.
void make_opencl_cache_writable();

}  // namespace nicol
