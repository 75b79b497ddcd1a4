/***
Below {{fig-07}} the speed of the track can be moved: the level stays, its two ends move, and for the heavier car B the short end moves sooner.
*/
#include "report/answer.hpp"
#include "num/log_spaced.hpp"
#include "sections.hpp"

namespace railbook::quality_chapter {

void limit_answer(report::Item& item) {
  report::Answer answer{
      item,
      {"speed_km/h"},
      {{"allowed amplitude", "wavelength, m", "amplitude, cm", 0.5, 1000, 0.01, 100, "log"},
       {.name = "ends", .kind = "says"}}};
  for (double v = 20; v < 210; v += 20) {
    answer.at({v});
    for (const char* key : {"A", "B"}) {
      const quality::Descriptor d{level_limit(), car(item, key), v * kmh};
      const quality::Envelope envelope{d};
      for (const double w : num::log_spaced(0.5, 1000, 20))
        answer.point("allowed amplitude", std::string{"car "} + key, w,
                     quality::allowed_amplitude(envelope(1 / w)) / cm);
      answer.says("ends", std::string{"level begins with car "} + key + ", m",
                  quality::lower_corner(d));
    }
    answer.says("ends", "level ends, m", quality::flat_until(level_limit(), v * kmh));
  }
}

}  // namespace railbook::quality_chapter
