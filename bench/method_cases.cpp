// SPDX-License-Identifier: BSD-3-Clause
#include "bench/method_cases.hpp"

#include "harness/motion/kinds/vortex.hpp"
#include "harness/sheet/sheet.hpp"
#include "mpm/seeding/lattice.hpp"

extern "C" const assay_material* assay_builtin_neo_hookean(std::uint32_t host_major, std::uint32_t index);

namespace assay::bench {

using namespace mpm;

std::vector<Case> method_cases() {
  const auto with = [](Basis basis, Formulation formulation, Transfer transfer, int terms) {
    Method method;
    method.basis = basis, method.formulation = formulation, method.transfer = transfer;
    if (terms > 1) method.mass = Mass::series, method.terms = terms;
    return method;
  };
  using enum Basis;
  const auto updated = Formulation::updated, total = Formulation::total;
  return {{"cpdi_flip", with(cpdi, updated, Transfer::flip, 1)},
          {"ugimp_flip", with(ugimp, updated, Transfer::flip, 1)},
          {"bspline2_flip", with(bspline2, updated, Transfer::flip, 1)},
          {"cpdi2_aflip_k2", with(cpdi2, updated, Transfer::aflip, 2)},
          {"total_bspline2_flip", with(bspline2, total, Transfer::flip, 1)},
          {"total_bspline2_aflip_k4", with(bspline2, total, Transfer::aflip, 4)}};
}

Setup<2> vortex(const Method& method, int across, int threads) {
  Setup<2> setup;
  const Vortex motion;
  const double h = (motion.outer - motion.inner) / across;
  const std::array<double, 2> lower{-motion.outer, -motion.outer}, upper{motion.outer, motion.outer};
  setup.method = method;
  setup.grid = grid_around(lower, upper, h, 4);
  setup.seeds = cartesian_lattice(lower, upper, h, {2, 2}, [&](const auto& X) {
    return motion.moves({X[0], X[1], 0}) ? Fate::stepped : Fate::absent;
  });
  order_by_nodes(setup);
  setup.density = 1000;
  setup.material = std::make_shared<const Material>(assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0),
                                                    std::map<std::string, double>{{"E", 1e3}, {"nu", 0.3}});
  setup.motion = motion;
  setup.body_force = true;
  setup.evaluation = Evaluation::domain_average;
  setup.exact = exact_polar(motion, setup.density,
                            std::make_shared<const Response>(Sheet(*setup.material, motion.baseline(), {})));
  setup.threads = threads;
  return setup;
}

}  // namespace assay::bench
