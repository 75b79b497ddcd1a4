#include <railbook/contact/normal_contact.hpp>

#include <railbook/units/input_error.hpp>

namespace railbook::contact {

double effective_modulus(const Material& m) {
  units::require_positive("Young's modulus of body 1", m.young_1, "Pa");
  units::require_positive("Young's modulus of body 2", m.young_2, "Pa");
  units::require_between("Poisson's ratio of body 1", m.poisson_1, 0, 0.5);
  units::require_between("Poisson's ratio of body 2", m.poisson_2, 0, 0.5);
  return 1 / ((1 - m.poisson_1 * m.poisson_1) / m.young_1 +
              (1 - m.poisson_2 * m.poisson_2) / m.young_2);
}

NormalContact empty_contact(double approach) {
  NormalContact contact;
  contact.approach = approach;
  contact.converged = true;
  contact.reason = empty_contact_reason;
  return contact;
}

}  // namespace railbook::contact
