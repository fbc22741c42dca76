// What samples where they matter win over uniform ones: times to 1 % and to 0.1 % of the same scene, in one run.
#pragma once
#include <string>

namespace nicol::bench {

// The scene at size x size pixels and 24 wavelengths; every setting `rounds` times in turn.
int compare_sampling(const std::string& scene, int size, int rounds);

}  // namespace nicol::bench
