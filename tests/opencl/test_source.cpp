// Kernel text: one source from many files, and logs that name the file and line.
#include <doctest/doctest.h>

#include "host/opencl/kernel_source.hpp"
#include "tests/opencl/stand_in.hpp"

using namespace nicol;

namespace {
int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}
std::string error_of(const std::string& file) {
  try {
    expand_includes(file);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "";
}
}  // namespace

TEST_CASE("includes become text with #line before and after") {
  const KernelFolder kernels({{"a.cl", "first\n  #  include \"b.h\"  // why\nlast\n"}, {"b.h", "middle\n"}});
  CHECK(expand_includes("a.cl") == "#line 1 \"a.cl\"\nfirst\n#line 1 \"b.h\"\nmiddle\n#line 3 \"a.cl\"\nlast\n");
}

TEST_CASE("guarded files come once, lists that are included on purpose come every time") {
  const KernelFolder kernels({{"a.cl", "#include \"g.h\"\n#include \"g.h\"\n#include \"l.def\"\n#include \"l.def\"\n"},
                              {"g.h", "// says what it is\n#ifndef G_H\n#define G_H\nguarded\n#endif\n"},
                              {"l.def", "row\n"}});
  const std::string text = expand_includes("a.cl");
  CHECK(count(text, "guarded\n") == 1);
  CHECK(count(text, "row\n") == 2);
}

TEST_CASE("a guarded file behind a condition is written out again where it may be needed") {
  const KernelFolder kernels({{"a.cl", "#ifdef NEVER\n#include \"g.h\"\n#endif\n#include \"g.h\"\n"},
                              {"g.h", "#ifndef G_H\n#define G_H\nguarded\n#endif\n"}});
  CHECK(count(expand_includes("a.cl"), "guarded\n") == 2);
}

TEST_CASE("a file that includes itself and a file that is nowhere are named") {
  const KernelFolder kernels({{"a.cl", "\n#include \"b.cl\"\n"}, {"b.cl", "\n\n#include \"a.cl\"\n"},
                              {"c.cl", "#include \"gone.h\"\n"}});
  CHECK(error_of("a.cl") == "b.cl:3: 'a.cl' includes itself");
  CHECK(error_of("c.cl").find("'gone.h'") != std::string::npos);
}

TEST_CASE("the embedded kernels are whole: long files lose nothing where chunks meet") {
  for (const EmbeddedFile& file : embedded_kernels()) {
    REQUIRE(!file.chunks.empty());
    for (std::size_t i = 0; i + 1 < file.chunks.size(); ++i) CHECK(file.chunks[i].size() >= 11000);
    CHECK(file.chunks.back().back() == '\n');
  }
  CHECK(kernel_file("abi.h").find("#ifndef NICOL_ABI_H") != std::string::npos);
}

TEST_CASE("a kernel that does not build is told with file, line, device and options") {
  const KernelFolder kernels({{"trace.cl", "#include \"portable.h\"\n#include \"wrong.h\"\n"},
                              {"wrong.h", "// one\nint f(void) { return nothing_here; }\n"}});
  try {
    prepare_kernel(*open_device("0"), 0, {});
    FAIL("built");
  } catch (const DeviceError& error) {
    const std::string message = error.what();
    CHECK(message.find("clBuildProgram failed with CL_BUILD_PROGRAM_FAILURE on " + list_devices()[0].name) == 0);
    CHECK(message.find("wrong.h:2") != std::string::npos);
    CHECK(message.find("nothing_here") != std::string::npos);
    CHECK(message.find("-D LANES=") != std::string::npos);
    CHECK(message.find("`nicol devices`") != std::string::npos);
  }
}

TEST_CASE("a kernel file without the entry point is an error by name") {
  const KernelFolder kernels;
  kernels.write("trace.cl", "__kernel void other(__global int* x) { x[0] = 1; }\n");
  CHECK_THROWS_WITH_AS(prepare_kernel(*open_device("0"), 0, {}), doctest::Contains("CL_INVALID_KERNEL_NAME"),
                       DeviceError);
}

TEST_CASE("options keep the arithmetic strict") {
  const KernelFolder kernels;
  KernelOptions options;
  options.real_double = true;
  const std::string text = prepare_kernel(*open_device("0"), 5, options).options;
  for (const char* part : {"-cl-std=CL1.2", "-D REAL_DOUBLE", "-D SCENE_FEATURES=5", "-D LOCAL_SIZE="})
    CHECK(text.find(part) != std::string::npos);
  for (const char* part : {"fast-relaxed", "finite-math", "no-signed-zeros", "unsafe"})
    CHECK(text.find(part) == std::string::npos);
  options.generic = true;
  CHECK(prepare_kernel(*open_device("0"), 5, options).options.find("SCENE_FEATURES") == std::string::npos);
}
