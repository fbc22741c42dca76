// POV-Ray's command line (+Iscene.pov +W640 Declare=a=1) as nicol's own options.
#pragma once
#include <string>
#include <vector>

namespace nicol::app {

// Arguments after `render`. What is not POV-Ray's passes through; switches that say nothing to
// nicol are dropped and named in `ignored`. Throws UsageError for a switch that cannot be obeyed.
std::vector<std::string> translate_povray_switches(const std::vector<std::string>& arguments,
                                                   std::vector<std::string>& ignored);

}  // namespace nicol::app
