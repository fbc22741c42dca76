// See plugin_sink.hpp.
#include "host/plugins/plugin_sink.hpp"

#include <filesystem>

#include "host/output/atomic_file.hpp"
#include "host/output/sinks.hpp"
#include "host/plugins/nicol_plugin.h"

namespace nicol::plugins {

namespace {

class PluginSink : public FrameSink {
 public:
  PluginSink(const Sink& sink, std::string path) : sink_(sink), path_(std::move(path)) {}

  void write(const Frame& frame) override {
    check_frame(frame, path_);
    const std::vector<float> rgb = linear_rgb(frame);
    const auto notes = notes_of(frame);
    std::vector<const char*> names, values;
    for (const auto& [name, value] : notes) {
      names.push_back(name.c_str());
      values.push_back(value.c_str());
    }
    nicol_picture_v1 picture{};
    picture.struct_size = sizeof picture;
    picture.width = frame.width;
    picture.height = frame.height;
    picture.wavelength_count = static_cast<std::uint32_t>(frame.lambda_nm.size());
    picture.lambda_nm = frame.lambda_nm.data();
    picture.weight_nm = frame.weight_nm.data();
    picture.stokes = frame.stokes.data();
    picture.rgb = rgb.data();
    picture.note_names = names.data();
    picture.note_values = values.data();
    picture.note_count = static_cast<std::uint32_t>(notes.size());
    AtomicFile file(path_);
    try {
      sink_.write(picture, file.unfinished_name());
    } catch (const PluginError& error) {
      cannot_write(path_, error.what());
    }
    const std::string sink = "plugin " + sink_.file + ": sink '" + sink_.name + "'";
    if (!std::filesystem::is_regular_file(file.unfinished_name())) cannot_write(path_, sink + " has left no file");
    if (std::filesystem::is_empty(file.unfinished_name())) cannot_write(path_, sink + " says that it is done, and has written nothing");
    file.commit();
  }

 private:
  const Sink& sink_;
  std::string path_;
};

}  // namespace

std::unique_ptr<FrameSink> make_plugin_sink(const Sink& sink, const std::string& path) {
  return std::make_unique<PluginSink>(sink, path);
}

}  // namespace nicol::plugins
