#include <railbook/scene/labelled.hpp>

#include <filesystem>

#include <railbook/files/staged.hpp>
#include <railbook/plot/plot.hpp>
#include <railbook/scene/image.hpp>

namespace railbook::scene {

void labelled(report::Item& item, const std::string& script, const Scene& scene,
              const Camera& camera, const Size& size, const std::vector<Label>& labels) {
  item.script(script);
  report::Data& places = item.data("labels", {"x_px", "y_px", "label"});
  for (const Label& label : labels) {
    const Eigen::Vector2d at = project(camera, size, label.at);
    places.add(at.x(), at.y(), label.text);
  }
  item.image([scene, camera, size, text = places.text(),
              script = item.sources() / script](const std::filesystem::path& png) {
    files::PrivateFolder folder;
    Scene dense = scene;  // at the twice as many pixels of all pictures
    for (Lines& lines : dense.lines) lines.width *= 2;
    const auto picture =
        folder.write("scene.png", png_of(render(dense, camera, {2 * size.width, 2 * size.height})));
    plot::render(script, {picture, folder.write("labels.csv", text)}, png);
  });
}

}  // namespace railbook::scene
