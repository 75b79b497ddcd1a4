#include <cstdio>

#include <railbook/contact/hertz.hpp>
#include <railbook/spectra/classify.hpp>

int main() {
  const auto c = railbook::spectra::classify(5e-7, 0.011);
  std::printf("class %d\n", c.track_class);
  return c.track_class == 5 ? 0 : 1;
}
