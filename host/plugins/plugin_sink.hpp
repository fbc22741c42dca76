// Pictures written by plugins.
#pragma once
#include <memory>
#include <string>

#include "host/output/frame.hpp"
#include "host/plugins/library.hpp"

namespace nicol::plugins {

// `sink` must last; those of a loaded library do. OutputError for a folder that takes no files.
std::unique_ptr<FrameSink> make_plugin_sink(const Sink& sink, const std::string& path);

}  // namespace nicol::plugins
