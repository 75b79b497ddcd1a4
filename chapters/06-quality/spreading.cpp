/*** ## How the histogram spreads

The paper likens the histogram of a deteriorating track to "a viscous blob resting on a horizontal
surface". A thin layer of viscous liquid, whose height $h$ stands for the density of the histogram,
spreads along the axis of $p$ by

$$\frac{\partial h}{\partial t}=\frac13\frac{\partial}{\partial p}\left(h^3\frac{\partial h}{\partial p}\right)$$

in scaled units of time $t$. The plain alternative is diffusion, $\partial h/\partial
t=D\,\partial^2h/\partial p^2$, which keeps a normal histogram normal; its constant is here $D$ =
{{diffusivity}}. Both have exact solutions, drawn here from the same standard deviation at $t=1$. 

{{fig-10}}

The difference is in the tails, which is where the thresholds are. Diffusion puts some values beyond
any threshold at once. The blob has an edge that moves as $p_N\propto t^{1/5}$, here {{blob-front}}
at $t=1$, and no value lies beyond it. Its standard deviation is $\sqrt{3/11}$ of $p_N$. Taken
literally, the blob says that no value exceeds a threshold until its edge arrives there.

{{fig-11}}

The paper describes two segments of track that start alike and then differ: A, where the ties
(sleepers) were renewed, and B, which was only surfaced, that is, lifted back to its proper height.
Its curves have no numbers. Here both spread by diffusion from $s$ = 0.15, B four times as fast. The
index $n$ of B falls to 3, taken as the end of basic maintenance, after {{basic-B}} units of
tonnage, that of A after {{basic-A}}. The histogram after surfacing does not tell which is which, as
the paper says.

The paper therefore asks for a function beside the *track-quality index* (TQI). It writes dTQI =
f(S, U, P, M), with letters that have these meanings here only: the change of the index depends on
the structure S, the use U, the present track quality P, and anything else, M, such as unusual
rainfall. P is there because of the hypothesis that poor track degrades faster than good track.
Neither law drawn here does that; in both the spreading slows down.

{{fold}}
*/
#include <cmath>

#include <railbook/quality/quality_index.hpp>
#include <railbook/quality/spreading.hpp>

#include "sections.hpp"

namespace railbook::quality_chapter {

namespace {

double gaussian(double x, double s) {
  return std::exp(-0.5 * x * x / (s * s)) / (s * std::sqrt(2 * units::pi));
}

constexpr double diffusivity = 0.01;

void fig_10(report::Item& item) {
  auto& data = item.data({"t", "x", "diffusion", "blob"});
  const double initial = std::sqrt(3.0 / 11) * quality::blob_front(1);
  for (const double t : {1.0, 8.0, 64.0}) {
    const double sd = quality::diffused_deviation(initial, diffusivity, t - 1);
    for (int i = -400; i <= 400; ++i)
      data.add(t, 0.01 * i, gaussian(0.01 * i, sd), quality::blob_height(0.01 * i, t));
    data.gap();
  }
  item.value("blob-front", quality::blob_front(1), "", "{:.3f}");
  item.value("diffusivity", diffusivity, "", "{:g}");
  item.rebuilt("the paper's figure is a sketch; both laws and all numbers are chosen");
}

// The two segments: mean 0 and T_2 as in Figure 9; tonnage in units in which 2 D = 0.005 for A.
constexpr double start_deviation = 0.15;

double margin(double D, double tonnage) {
  return repair_threshold() / quality::diffused_deviation(start_deviation, D, tonnage);
}

void fig_11(report::Item& item) {
  auto& data = item.data({"tonnage", "s_A", "s_B", "n_A", "n_B"});
  constexpr double D_A = 0.0025, D_B = 4 * D_A;
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.1 * i;
    data.add(t, quality::diffused_deviation(start_deviation, D_A, t),
             quality::diffused_deviation(start_deviation, D_B, t), margin(D_A, t), margin(D_B, t));
  }
  const auto until = [](double D) {
    const double s = repair_threshold() / 3;
    return (s * s - start_deviation * start_deviation) / (2 * D);
  };
  const double now = margin(D_A, 0), later = margin(D_A, 5), last = margin(D_A, 10);
  item.claims({{"n", {later / last, now / later}}});
  report::values(item, "", "{:.1f}", "basic-A", until(D_A), "basic-B", until(D_B));
  item.rebuilt("two curves without numbers in the paper; law and rates are chosen");
}

}  // namespace

const report::Section spreading{report::figure("fig-10", fig_10), report::figure("fig-11", fig_11)};

}  // namespace railbook::quality_chapter
