// SPDX-License-Identifier: BSD-3-Clause
// Some steps of one method and nothing else: for tools that look at a program from outside.
//   run_steps CASE CELLS_ACROSS STEPS    the number of particles; without a case: all of them
#include <cstdio>
#include <cstdlib>

#include "bench/method_cases.hpp"
#include "mpm/simulation.hpp"

int main(int count, char** words) {
  using namespace assay;
  for (const bench::Case& c : bench::method_cases()) {
    if (count == 1) std::printf("%s\n", c.name.c_str());
    if (count != 4 || c.name != words[1]) continue;
    mpm::Simulation<2> simulation(bench::vortex(c.method, std::atoi(words[2]), 1));
    for (int k = 0; k < std::atoi(words[3]); ++k) simulation.step(bench::step_begin, bench::step_length);
    std::printf("%zu\n", simulation.state().particles);
    return simulation.state().finding ? 1 : 0;
  }
  return count == 1 ? 0 : 2;
}
