// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/response.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_response {
namespace {

const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 1.0, 1.0}}.baseline();
constexpr double t = 0.3;
constexpr std::size_t points = 3 * ClosedForm::at_once + 7;

std::vector<double> places() {
  std::vector<double> xi(points);
  for (std::size_t i = 0; i < points; ++i)
    xi[i] = path.parameter.lower + path.parameter.width() * static_cast<double>(i) / (points - 1);
  return xi;
}

TEST(Response, AClosedFormAnswersManyPointsAsItAnswersOne) {
  const Response response(*ClosedForm::of(elastic_material(), path));
  const auto now = response.at_time(t);
  const std::vector<double> xi = places();
  std::vector<double> many(4 * points);
  now->plane_tau(xi, many, in_one_piece);
  Tensor tau, slope;
  for (std::size_t i = 0; i < points; ++i) {
    now->at(xi[i], tau, slope);
    const double one[] = {tau(0, 0), tau(0, 1), tau(1, 0), tau(1, 1)};
    for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(many[c * points + i], one[c]) << i << ' ' << c;
  }
}

constexpr double most = 0.11;  ///< eps that the form below takes

std::int32_t form_up_to(void*, std::int32_t, std::size_t n, const double* eps, double* tau, double* slope) {
  if (std::any_of(eps, eps + n, [](double each) { return each > most; })) return ASSAY_FAILED;
  std::fill_n(tau, 9 * n, 1.0);
  std::fill_n(slope, 9 * n, 0.0);
  return ASSAY_GOOD;
}

const void* only_the_form(const char* id) {
  static const assay_closed_form form{sizeof(assay_closed_form), form_up_to};
  return std::strcmp(id, ASSAY_EXTENSION_CLOSED_FORM) == 0 ? &form : nullptr;
}

TEST(Response, TheFirstPointThatAClosedFormRefusesIsNamed) {
  static assay_material table = elastic_material()->table();
  table.extension = only_the_form;
  const auto material = std::make_shared<const Material>(&table, elastic_material()->named_parameters());
  const Response response(*ClosedForm::of(material, path));
  const double g = path.amplitude(t);
  const std::vector<double> xi = places();
  const auto first = std::find_if(xi.begin(), xi.end(), [g](double each) { return each * g > most; });
  ASSERT_NE(first, xi.end());
  ASSERT_GT(first - xi.begin(), static_cast<std::ptrdiff_t>(ClosedForm::at_once)) << "in the first call";
  std::vector<double> tau(4 * points);
  try {
    response.at_time(t)->plane_tau(xi, tau, in_one_piece);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const MaterialFailure& failure) {
    EXPECT_EQ(failure.xi, *first);
    EXPECT_EQ(failure.t, t);
  }
}

}  // namespace
}  // namespace assay::test_response
