// The parts of the window beside and over the pictures. Each is drawn anew in every frame.
#pragma once
#include "host/window/ui.hpp"

namespace nicol::window {

void side_panel(Ui& ui);             // tabs, and below them the values of a pixel

// The tabs' contents.
void view_tab(Ui& ui);
void polarizers_tab(Ui& ui);
void effects_tab(Ui& ui);
void camera_tab(Ui& ui);
void save_tab(Ui& ui);

void pixel_panel(Ui& ui);
void pane_overlay(Ui& ui, int pane); // title, false-colour scale, ellipses, the pixel's place
void message_box(Ui& ui, int pane);  // errors and warnings over the lower part of a pane
void status_line(Ui& ui);
void help_overlay(Ui& ui);

void copy_camera(preview::Session& session, Surface& surface);   // as text of the scene language, to the clipboard

}  // namespace nicol::window
