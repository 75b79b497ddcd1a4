#include <railbook/contact/material.hpp>

#include <railbook/units/input_error.hpp>

namespace railbook::contact {

double effective_modulus(const Material& one, const Material& two) {
  units::require_positive("Young's modulus of body 1", one.young, "Pa");
  units::require_positive("Young's modulus of body 2", two.young, "Pa");
  units::require_between("Poisson's ratio of body 1", one.poisson, 0, 0.5);
  units::require_between("Poisson's ratio of body 2", two.poisson, 0, 0.5);
  return 1 / ((1 - one.poisson * one.poisson) / one.young +
              (1 - two.poisson * two.poisson) / two.young);
}

}  // namespace railbook::contact
