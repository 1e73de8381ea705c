// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion.hpp"

namespace assay {

namespace {

double period(const Vortex& motion) { return motion.amplitude.period; }
double period(const Homogeneous& motion) { return motion.period; }
double period(const RotatingStretch& motion) { return motion.period; }
double period(const DeformationTable& motion) { return motion.last(); }

}  // namespace

double period_of(const Motion& motion) {
  return std::visit([](const auto& m) { return period(m); }, motion);
}

}  // namespace assay
