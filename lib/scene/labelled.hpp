// A rendered scene as a figure of a chapter, with labels put over it by gnuplot.
//
//   scene::labelled(item, "car.gp", scene, camera, size, {{{0, 0, 1.2}, "wheel"}, {{2, 0, 0},
//   "rail"}});
//
// The script, of the chapter's folder, gets the picture as ARG1 and the labels' pixels as ARG3;
// lib/plot/scene.gp says what to write in it.
#pragma once

#include <string>
#include <vector>

#include <railbook/report/item.hpp>
#include <railbook/scene/scene.hpp>

namespace railbook::scene {

struct Label {
  Point at;  // in the scene's unit
  std::string text;
};

// Gives the item its image and the data "labels" (x_px, y_px, label). Nothing is rendered when
// figures are not drawn. Throws InputError when the camera or a label's place is one that
// scene::project refuses.
void labelled(report::Item& item, const std::string& script, const Scene& scene,
              const Camera& camera, const Size& size, const std::vector<Label>& labels);

}  // namespace railbook::scene
