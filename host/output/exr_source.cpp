// See exr_source.hpp.
#include "host/output/exr_source.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "host/output/exr_threads.hpp"
#include "host/output/frame.hpp"

namespace nicol {
namespace {

constexpr const char* note_prefix = "nicol:";
constexpr int most_pixels_across = 65536;

// What OpenEXR says of a missing file is less than what the system says.
void check_readable(const std::string& path) {
  errno = 0;
  if (!std::ifstream(path, std::ios::binary)) cannot_read(path, errno ? std::strerror(errno) : "it cannot be opened");
}

}  // namespace

struct ExrSource::File {
  explicit File(const std::string& path) : input(path.c_str(), exr_threads()) {}
  Imf::InputFile input;
};

ExrSource::ExrSource(const std::string& path) : path_(path) {
  check_readable(path);
  try {
    file_ = std::make_unique<File>(path);
  } catch (const std::exception& error) {
    cannot_read(path, error.what());
  }
  const Imf::Header& header = file_->input.header();
  const Imath::Box2i window = header.dataWindow();
  if (window.min.x != 0 || window.min.y != 0 || window.max.x >= most_pixels_across || window.max.y >= most_pixels_across)
    cannot_read(path, "its data window does not begin at 0, 0, or is too large");
  width_ = window.max.x + 1;
  height_ = window.max.y + 1;
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
    if (text && std::strncmp(attribute.name(), note_prefix, std::strlen(note_prefix)) == 0)
      notes_[attribute.name() + std::strlen(note_prefix)] = text->value();
  }
}

ExrSource::~ExrSource() = default;

bool ExrSource::whole() const { return file_->input.isComplete(); }

bool ExrSource::has_channel(const std::string& name) const {
  return file_->input.header().channels().findChannel(name) != nullptr;
}

void ExrSource::read_rows(int first, int count, const std::vector<std::pair<std::string, float*>>& channels) {
  const std::size_t row = static_cast<std::size_t>(width_) * sizeof(float);
  Imf::FrameBuffer pixels;
  for (const auto& [name, to] : channels) {
    const Imf::Channel* channel = file_->input.header().channels().findChannel(name);
    if (!channel) cannot_read(path_, "it has no channel " + name);
    if (channel->type != Imf::FLOAT || channel->xSampling != 1 || channel->ySampling != 1)
      cannot_read(path_, "its channel " + name + " is not one FLOAT a pixel");
    pixels.insert(name, Imf::Slice::Make(Imf::FLOAT, to, Imath::V2i(0, first), width_, count, sizeof(float), row));
  }
  try {
    file_->input.setFrameBuffer(pixels);
    file_->input.readPixels(first, first + count - 1);
  } catch (const std::exception& error) {
    cannot_read(path_, error.what());
  }
}

void cannot_read(const std::string& path, const std::string& reason) {
  throw InputError("cannot read " + path + ": " + reason);
}

}  // namespace nicol
