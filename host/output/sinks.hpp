// The sinks that write files. make_sink() in frame.hpp picks one by the suffix.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "host/output/frame.hpp"

namespace nicol {

// piz: smallest and quickest of the lossless ways; none: for readers without it.
enum class ExrPacking { piz, none };

std::unique_ptr<FrameSink> make_exr_sink(const std::string& path,
                                         ExrPacking packing = ExrPacking::piz);
std::unique_ptr<FrameSink> make_png_sink(const std::string& path);

// Sinks for a further suffix (".csv"), from now until the process ends; the last one that is added for a suffix counts.
using SinkMaker = std::function<std::unique_ptr<FrameSink>(const std::string& path)>;
void add_sink_maker(const std::string& suffix, SinkMaker make);

// "S0.580,000000nm" of "S0" and 580.
std::string channel_name(const std::string& quantity, double lambda_nm);

// Frame::how and, if rows are missing, {"partial", "N of M rows"}: what both formats tell of the
// making.
std::vector<std::pair<std::string, std::string>> notes_of(const Frame& frame);

// Throws OutputError for a picture without pixels, or with arrays that do not fit its size.
void check_frame(const Frame& frame, const std::string& path);

}  // namespace nicol
