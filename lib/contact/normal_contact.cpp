#include <railbook/contact/normal_contact.hpp>

namespace railbook::contact {

NormalContact empty_contact(double approach) {
  NormalContact contact;
  contact.approach = approach;
  contact.converged = true;
  contact.reason = empty_contact_reason;
  return contact;
}

}  // namespace railbook::contact
