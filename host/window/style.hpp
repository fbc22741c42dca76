// Looks: neutral greys around pictures that are judged by their colour.
#pragma once
#include <imgui.h>

namespace nicol::window {

struct Fonts {
  ImFont* text = nullptr;
  ImFont* mono = nullptr;
};

// Rebuilds ImGui's fonts, sharp at that scale. Where no known font file is on the machine: ImGui's own.
Fonts load_fonts(double content_scale);

void set_style();

namespace colours {
inline constexpr ImU32 surroundings = IM_COL32(38, 38, 38, 255);
inline constexpr ImU32 text = IM_COL32(222, 222, 222, 255);
inline constexpr ImU32 dim = IM_COL32(150, 150, 150, 255);
inline constexpr ImU32 faint = IM_COL32(92, 92, 92, 255);
inline constexpr ImU32 shade = IM_COL32(20, 20, 20, 190);       // behind text over a picture
inline constexpr ImU32 error = IM_COL32(240, 128, 112, 255);
inline constexpr ImU32 warning = IM_COL32(226, 190, 110, 255);
inline constexpr ImU32 right_handed = IM_COL32(255, 176, 96, 255);
inline constexpr ImU32 left_handed = IM_COL32(112, 184, 255, 255);
inline constexpr ImU32 linear = IM_COL32(235, 235, 235, 255);
inline constexpr ImU32 stokes[4] = {IM_COL32(230, 230, 230, 255), IM_COL32(236, 132, 112, 255),
                                    IM_COL32(124, 200, 124, 255), IM_COL32(122, 170, 250, 255)};
}  // namespace colours

}  // namespace nicol::window
