// SPDX-License-Identifier: BSD-3-Clause
// Negative controls of test_all_models.cpp: a model with one planted bug, which the measure of that property must see.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/adapters/models/properties.hpp"

namespace assay::model_tests::test_planted_bugs {
namespace {

enum class Bug { none, frame, impure, batch, rest, scalar, tangent, rate, energy, closed_form, slope };

struct Plant {
  const assay_material* real = nullptr;
  Bug bug = Bug::none;
  int calls = 0;
} plant;

constexpr double off = 1 + 1e-4;

void planted_update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                    double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
  plant.real->update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
  for (std::size_t p = 0; p < n; ++p) {
    double& shear = cauchy[n + p];
    if (plant.bug == Bug::frame) shear += 1e-6 * (step->F1[n + p] - step->F1[3 * n + p]);
    if (plant.bug == Bug::impure) shear *= 1 + 1e-15 * (plant.calls++ % 7);
    if (plant.bug == Bug::batch && p > 0) shear = std::nextafter(shear, 1e300);
    if (plant.bug == Bug::rest) shear += 1e-9;
    if (plant.bug == Bug::scalar) state1[p] = std::nextafter(state1[p], 1e300);
  }
}

template <class Extension>
const Extension& real_extension(const char* id) {
  return *static_cast<const Extension*>(plant.real->extension(id));
}

std::int32_t planted_tangent(void* self, const assay_step* step, std::size_t n, const double* state0, double* out) {
  const auto status = real_extension<assay_tangent>(ASSAY_EXTENSION_TANGENT).tangent(self, step, n, state0, out);
  out[10 * n] *= off;
  return status;
}

std::int32_t planted_rate(void* self, double t, std::size_t n, const double* F, const double* l, const double* cauchy,
                          const double* state, double* cauchy_rate, double* state_rate) {
  const auto& real = real_extension<assay_rate>(ASSAY_EXTENSION_RATE);
  const auto status = real.rate(self, t, n, F, l, cauchy, state, cauchy_rate, state_rate);
  for (std::size_t p = 0; p < n; ++p) state_rate[p] *= off;
  return status;
}

std::int32_t planted_energy(void* self, std::size_t n, const double* F, const double* state, double* W) {
  const auto status = real_extension<assay_energy>(ASSAY_EXTENSION_ENERGY).energy(self, n, F, state, W);
  for (std::size_t p = 0; p < n; ++p) W[p] *= off;
  return status;
}

std::int32_t planted_closed_form(void* self, std::int32_t baseline, std::size_t n, const double* eps, double* tau,
                                 double* slope) {
  const auto& real = real_extension<assay_closed_form>(ASSAY_EXTENSION_CLOSED_FORM);
  const auto status = real.tau(self, baseline, n, eps, tau, slope);
  for (std::size_t i = 0; i < 9 * n; ++i) (plant.bug == Bug::slope ? slope : tau)[i] *= 1 + 1e-8;
  return status;
}

const void* planted_extension(const char* id) {
  static const assay_tangent tangent{sizeof(assay_tangent), planted_tangent};
  static const assay_rate rate{sizeof(assay_rate), planted_rate};
  static const assay_energy energy{sizeof(assay_energy), planted_energy};
  static const assay_closed_form form{sizeof(assay_closed_form), planted_closed_form};
  const auto asked = [&](const char* known, Bug bug) { return plant.bug == bug && std::strcmp(id, known) == 0; };
  if (asked(ASSAY_EXTENSION_TANGENT, Bug::tangent)) return &tangent;
  if (asked(ASSAY_EXTENSION_RATE, Bug::rate)) return &rate;
  if (asked(ASSAY_EXTENSION_ENERGY, Bug::energy)) return &energy;
  if (asked(ASSAY_EXTENSION_CLOSED_FORM, Bug::closed_form) || asked(ASSAY_EXTENSION_CLOSED_FORM, Bug::slope)) {
    return &form;
  }
  return plant.real->extension(id);
}

/// The measure without and with the bug.
void expect_seen(Bug bug, const std::string& model, const Parameters& parameters, Measured (*measure)(const Material&),
                 double bound) {
  plant = {adapters::builtin_table(model), Bug::none, 0};
  assay_material table = *plant.real;
  table.update = planted_update;
  table.extension = planted_extension;
  const Material material(&table, parameters);
  const Measured sound = measure(material);
  EXPECT_GT(sound.visited, 0);
  EXPECT_LE(sound.error, bound);
  plant.bug = bug;
  EXPECT_GT(measure(material).error, bound) << static_cast<int>(bug);
}

TEST(AllModelsNegativeControl, PlantedBugsAreSeen) {
  const Parameters elastic{{"E", 1000}, {"nu", 0.3}}, plastic{{"E", 1000}, {"nu", 0.3}, {"yield_stress", 20}};
  const std::string j2 = "j2_multiplicative";
  expect_seen(Bug::rate, j2, plastic, rate_error, 2e-5);
  expect_seen(Bug::tangent, j2, plastic, tangent_error, 1e-6);
  expect_seen(Bug::frame, j2, plastic, objectivity_error, 1e-11);
  expect_seen(Bug::energy, j2, plastic, energy_error, 1e-7);
  expect_seen(Bug::impure, j2, plastic, impurity, 0);
  expect_seen(Bug::batch, j2, plastic, impurity, 0);
  expect_seen(Bug::closed_form, "hypoelastic_jaumann", elastic, closed_form_error, 1e-11);
  expect_seen(Bug::slope, "hypoelastic_jaumann", elastic, closed_form_slope_error, 1e-10);
  expect_seen(Bug::rest, j2, plastic, rest_error, 1e-12);
  expect_seen(Bug::scalar, j2, plastic, regime_error, 0);
}

}  // namespace
}  // namespace assay::model_tests::test_planted_bugs
