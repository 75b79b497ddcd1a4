// GSL's status codes as exceptions. By default GSL aborts the program on an error.
#pragma once

#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>

namespace railbook::num {

// A numerical routine failed in a way its caller cannot go on from: a bug or a case out of its
// range.
class NumericalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Switches GSL's aborting handler off for the whole program; safe to call often. Every wrapper of
// this folder calls it before it calls GSL.
void use_gsl_status_codes();

// Throws NumericalError naming `what` and GSL's own text unless `status` is GSL_SUCCESS. Underflow
// to zero is accepted as the right answer.
void check_gsl(int status, std::string_view what);

// Owns a workspace of GSL, which returns none when there is no memory: throws std::bad_alloc then.
template <class Workspace>
std::unique_ptr<Workspace, void (*)(Workspace*)> gsl_owned(Workspace* workspace,
                                                           void (*free)(Workspace*)) {
  if (workspace == nullptr) throw std::bad_alloc{};
  return {workspace, free};
}

}  // namespace railbook::num
