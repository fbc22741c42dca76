// Spectral, polarized OpenEXR in one part.
// Layout: Fichet, Pacanowski & Wilkie 2021, "An OpenEXR layout for spectral images", JCGT 10(3):
// channels S0..S3 per wavelength, `S0.580,000000nm` with a decimal comma; R, G, B beside them for
// other readers.
#include <ImfAttribute.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <new>

#include "host/output/atomic_file.hpp"
#include "host/output/exr_threads.hpp"
#include "host/output/sinks.hpp"

namespace nicol {
namespace {

class ExrStream : public Imf::OStream {
 public:
  ExrStream(AtomicFile& file, const std::string& path) : OStream(path.c_str()), file_(file) {}
  void write(const char bytes[], int count) override {
    file_.write(bytes, static_cast<std::size_t>(count));
  }
  std::uint64_t tellp() override { return file_.position(); }
  void seekp(std::uint64_t position) override { file_.seek(position); }

 private:
  AtomicFile& file_;
};

// An attribute's name keeps letters, digits and a few signs, so that every tool can show it.
std::string attribute_name(const std::string& key) {
  std::string name = "nicol:" + key;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != ':' && c != '.' && c != '-') c = '_';
  return name;
}

class Layout {
 public:
  Layout(const Frame& frame, const std::vector<float>& rgb, ExrPacking packing)
      : width_(static_cast<std::size_t>(frame.width)), header_(frame.width, frame.height) {
    // Parts are full of holes: wavelets spread them, ZIP makes them nearly nothing.
    const bool holes = std::any_of(frame.planes.begin(), frame.planes.end(), [](const auto& named) { return named.first == "weight"; });
    header_.compression() = packing == ExrPacking::none ? Imf::NO_COMPRESSION : holes ? Imf::ZIP_COMPRESSION : Imf::PIZ_COMPRESSION;
    for (int k = 0; k < 3; ++k) add(std::string(1, "RGB"[k]), rgb.data() + k, 3);
    if (!frame.cut_off.empty()) add("cutoff", frame.cut_off.data(), 1);
    if (!frame.sample_error.empty()) add("error.sampling", frame.sample_error.data(), 1);
    for (const auto& [name, plane] : frame.planes) add(name, plane.data(), 1);
    for (int s = 0; s < 4; ++s)
      for (std::size_t i = 0; i < frame.lambda_nm.size(); ++i)
        add(channel_name("S" + std::to_string(s), frame.lambda_nm[i]), frame.component(s, i), 1);
    describe(frame);
  }
  const Imf::Header& header() const { return header_; }
  const Imf::FrameBuffer& pixels() const { return pixels_; }

 private:
  void add(const std::string& name, const float* first, std::size_t stride) {
    header_.channels().insert(name, Imf::Channel(Imf::FLOAT));
    auto* base = const_cast<char*>(reinterpret_cast<const char*>(first));  // the library only reads
    pixels_.insert(name, Imf::Slice(Imf::FLOAT, base, stride * sizeof(float),
                                    stride * width_ * sizeof(float)));
  }

  void describe(const Frame& frame) {
    const auto set = [this](const std::string& name, const std::string& value) {
      header_.insert(name, Imf::StringAttribute(value));
    };
    set("spectralLayoutVersion", "1.0");
    set("emissiveUnits", "W.m^-2.sr^-1");
    set("polarisationHandedness", "right");
    Imf::addChromaticities(header_,
                           Imf::Chromaticities());  // the default is Rec. 709, sRGB's primaries
    for (const auto& [key, value] : notes_of(frame)) set(attribute_name(key), value);
  }

  std::size_t width_;
  Imf::Header header_;
  Imf::FrameBuffer pixels_;
};

class ExrSink : public FrameSink {
 public:
  ExrSink(std::string path, ExrPacking packing) : path_(std::move(path)), packing_(packing) {}

  void write(const Frame& frame) override {
    check_frame(frame, path_);
    const auto rgb = linear_rgb(frame);
    AtomicFile file(path_);
    try {
      write_pixels(Layout(frame, rgb, packing_), frame.height, file);
    } catch (const OutputError&) {
      throw;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      file.rethrow_error();
      cannot_write(path_, error.what());
    }
    file.rethrow_error();  // OpenEXR writes the end of the file in a destructor
    file.commit();
  }

 private:
  void write_pixels(const Layout& layout, int height, AtomicFile& file) const {
    ExrStream stream(file, path_);
    Imf::OutputFile output(stream, layout.header(), exr_threads());
    output.setFrameBuffer(layout.pixels());
    output.writePixels(height);
  }

  std::string path_;
  ExrPacking packing_;
};

}  // namespace

// No printf of a double: its decimal sign would follow the locale.
std::string channel_name(const std::string& quantity, double lambda_nm) {
  const long long femtometres = std::llround(lambda_nm * 1e6);
  char name[48];
  std::snprintf(name, sizeof name, ".%lld,%06lldnm", femtometres / 1000000, femtometres % 1000000);
  return quantity + name;
}

std::unique_ptr<FrameSink> make_exr_sink(const std::string& path, ExrPacking packing) {
  return std::make_unique<ExrSink>(path, packing);
}

}  // namespace nicol
