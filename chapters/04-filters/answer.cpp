/***
Below {{fig-09}} the car's speed can be moved. The analog filters run over the track's waves as it goes faster, the hybrid ones stay; what is left of the speed is how
far a run forwards and a run backwards lie apart.
*/
#include <cmath>

#include "configuration.hpp"
#include "filters/hybrid_filter.hpp"
#include "report/answer.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {

void speed_answer(report::Item& item) {
  using namespace filters;
  report::Answer answer{
      item,
      {"speed_mph"},
      {{"gyro: B, and BC", "wavelength, ft", "gain", 2, 1000, 0, 1.05, "logx"},
       {"accelerometer: F, and FG", "wavelength, ft", "gain", 2, 1000, 0, 1.05, "logx"},
       {.name = "direction", .kind = "says"}}};
  const SecondOrderLowPass low{.omega = acceleration_corner};
  for (const double mph : {1., 2., 3., 5., 9., 15., 20., 30., 45., 60., 80., 100., 120.}) {
    const double T = sample_distance / (mph * units::mph), kappa = gyro_corner * T;
    answer.at({mph});
    for (int i = 0; i <= 45; ++i) {
      const double feet = 2 * std::pow(500.0, i / 45.0), theta = 2 * units::pi / feet;
      const auto B = first_order_analog(kappa, theta);
      const auto F = second_order_analog(low, T, theta);
      answer.point("gyro: B, and BC", "analog B", feet, std::abs(B));
      answer.point("gyro: B, and BC", "hybrid BC", feet,
                   std::abs(B * first_order_digital(kappa, theta)));
      answer.point("accelerometer: F, and FG", "analog F", feet, std::abs(F));
      answer.point("accelerometer: F, and FG", "hybrid FG", feet,
                   std::abs(F * second_order_digital(low, T, theta)));
    }
    answer.says("direction", "forwards and backwards apart, mm",
                2 * (0.5 - centroid_delay(kappa)) * sample_distance / units::millimetre);
  }
}

}  // namespace railbook::filters_chapter
