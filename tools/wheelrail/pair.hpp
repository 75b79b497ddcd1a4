// Wheel, rail, materials and friction as options of a tool.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tool/options.hpp"
#include "tool/summary.hpp"
#include "wheel_on_rail/wheel.hpp"

namespace railbook::wheelrail_tool {

struct PairWish {
  std::filesystem::path wheel, rail;
  std::string head = "60E1";
  double cant = 0.025, gauge = 1.435, gauge_depth = 0.014;
  double back_to_back = 1.360, datum = 0.070, radius = 0.460;
  std::optional<double> noise;
  double speed = 0;
  std::string method = "full";
  long cells = 40;
  wheel_on_rail::WheelWish wheel_wish;
};

void add_pair_options(tool::Options& options, PairWish& wish);
// Throws InputError naming a file and what is wrong with it.
wheel_on_rail::Pair read_pair(const PairWish& wish);
void describe_pair(tool::Summary& answer, const PairWish& wish);
wheel_on_rail::WheelWish wheel_wish(const PairWish& wish);
wheel_on_rail::Method method_of(const std::string& name);

}  // namespace railbook::wheelrail_tool
