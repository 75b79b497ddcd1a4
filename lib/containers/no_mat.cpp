// Without libmatio only MATLAB 7.3 is read, which is HDF5.
#include <railbook/containers/container.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::containers {

Contents mat_contents(const std::filesystem::path&) {
  throw InputError{
      "a MAT file, and this railbook was built without libmatio; allowed: saved by -v7.3, or as "
      "CSV by writetable or writematrix"};
}

}  // namespace railbook::containers
