// The contact of the creep tools: semi-axes, or radii of bodies that Hertz's theory presses.
#pragma once

#include <optional>

#include <railbook/contact/material.hpp>
#include <railbook/rolling/case.hpp>
#include <railbook/rolling/material_pair.hpp>
#include <railbook/tool/options.hpp>
#include <railbook/tool/summary.hpp>

namespace railbook::creep_tool {

struct ContactOptions {
  std::optional<double> a, b;                                                  // m
  std::optional<double> wheel_radius, wheel_profile, rail_radius, rail_crown;  // m
  double load = 0;                                                             // N
  double friction = 0.3;
  contact::Material wheel = contact::default_steel, rail = contact::default_steel;

  void declare(tool::OptionParser& parser);
};

// The case without creepages; what it is goes into the answer. Throws InputError when neither axes
// nor radii are given, or both, or the contact is not smaller than its radii.
rolling::RollingCase contact_of(const ContactOptions& options, const rolling::MaterialPair& pair,
                                tool::Summary& answer);

}  // namespace railbook::creep_tool
