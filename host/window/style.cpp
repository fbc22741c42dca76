// See style.hpp.
#include "host/window/style.hpp"

#include <fstream>
#include <initializer_list>
#include <string>

namespace nicol::window {
namespace {

constexpr float text_height = 14, mono_height = 13;   // logical pixels

ImFont* font_of(std::initializer_list<const char*> files, float height, float scale) {
  // Latin, Greek, punctuation: what scenes and formulas are written in.
  static const ImWchar ranges[] = {0x20, 0x17f, 0x370, 0x3ff, 0x2010, 0x2027, 0x2190, 0x2193, 0x2212, 0x2212, 0};
  ImGuiIO& io = ImGui::GetIO();
  for (const char* folder : {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/TTF/", "/usr/share/fonts/dejavu/",
                             "/usr/share/fonts/dejavu-sans-fonts/", "/usr/share/fonts/dejavu-sans-mono-fonts/",
                             "/usr/share/fonts/truetype/liberation/", "/usr/share/fonts/liberation/"})
    for (const char* file : files) {
      const std::string path = std::string(folder) + file;
      if (std::ifstream(path).good())
        return io.Fonts->AddFontFromFileTTF(path.c_str(), height * scale, nullptr, ranges);
    }
  ImFontConfig config;
  config.SizePixels = height * scale;
  return io.Fonts->AddFontDefault(&config);
}

void set_grey(int colour, float level, float alpha = 1) {
  ImGui::GetStyle().Colors[colour] = ImVec4(level, level, level, alpha);
}

void set_spacing() {
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowPadding = {8, 8};
  style.FramePadding = {6, 3};
  style.ItemSpacing = {6, 6};
  style.ItemInnerSpacing = {4, 4};
  style.CellPadding = {4, 2};
  style.ScrollbarSize = 11;
  style.GrabMinSize = 10;
  style.WindowRounding = style.ChildRounding = style.PopupRounding = 0;
  style.FrameRounding = style.GrabRounding = style.TabRounding = 2;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
}

}  // namespace

Fonts load_fonts(double content_scale) {
  const float scale = static_cast<float>(content_scale);
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  Fonts fonts;
  fonts.text = font_of({"DejaVuSans.ttf", "LiberationSans-Regular.ttf"}, text_height, scale);
  fonts.mono = font_of({"DejaVuSansMono.ttf", "LiberationMono-Regular.ttf"}, mono_height, scale);
  io.FontGlobalScale = 1 / scale;
  return fonts;
}

void set_style() {
  ImGui::StyleColorsDark();
  set_spacing();
  set_grey(ImGuiCol_Text, 0.87F);
  set_grey(ImGuiCol_TextDisabled, 0.56F);
  set_grey(ImGuiCol_WindowBg, 0.125F);
  set_grey(ImGuiCol_ChildBg, 0, 0);
  set_grey(ImGuiCol_PopupBg, 0.11F, 0.98F);
  set_grey(ImGuiCol_Border, 0.28F);
  set_grey(ImGuiCol_FrameBg, 0.22F);
  set_grey(ImGuiCol_FrameBgHovered, 0.28F);
  set_grey(ImGuiCol_FrameBgActive, 0.32F);
  set_grey(ImGuiCol_CheckMark, 0.88F);
  set_grey(ImGuiCol_SliderGrab, 0.40F);
  set_grey(ImGuiCol_SliderGrabActive, 0.50F);
  set_grey(ImGuiCol_Button, 0.25F);
  set_grey(ImGuiCol_ButtonHovered, 0.33F);
  set_grey(ImGuiCol_ButtonActive, 0.40F);
  set_grey(ImGuiCol_Header, 0.25F);
  set_grey(ImGuiCol_HeaderHovered, 0.31F);
  set_grey(ImGuiCol_HeaderActive, 0.36F);
  set_grey(ImGuiCol_Separator, 0.26F);
  set_grey(ImGuiCol_Tab, 0.16F);
  set_grey(ImGuiCol_TabHovered, 0.36F);
  set_grey(ImGuiCol_TabActive, 0.30F);
  set_grey(ImGuiCol_TabUnfocused, 0.16F);
  set_grey(ImGuiCol_TabUnfocusedActive, 0.30F);
  set_grey(ImGuiCol_ScrollbarBg, 0, 0);
  set_grey(ImGuiCol_TableRowBgAlt, 1, 0.03F);
  set_grey(ImGuiCol_TitleBg, 0.18F);
  set_grey(ImGuiCol_TitleBgActive, 0.22F);
  set_grey(ImGuiCol_TextSelectedBg, 0.45F);
  set_grey(ImGuiCol_TableHeaderBg, 0.18F);
}

}  // namespace nicol::window
