// SPDX-License-Identifier: BSD-3-Clause
#include "harness/material/material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/harness/elastic_material.hpp"
#include "tests/harness/jaumann_material.hpp"

namespace assay::test_material {
namespace {

const assay_material* elastic() { return assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0); }

std::string refusal(const std::map<std::string, double>& parameters) {
  try {
    Material(elastic(), parameters);
  } catch (const ParameterError& error) {
    return error.key();
  }
  return "accepted";
}

TEST(Material, FillsDefaultsInDeclaredOrder) {
  const Material material(elastic(), {{"E", 5.0}});
  EXPECT_EQ(material.parameters(), (std::vector<double>{5.0, 0.3}));
  EXPECT_EQ(material.parameter("nu"), 0.3);
  EXPECT_THROW(material.parameter("K"), ParameterError);
}

TEST(Material, ChecksItsParameters) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal({{"E", 1.0}, {"nu", 0.2}}), "accepted");
  EXPECT_EQ(refusal({{"nu", 0.2}}), "E");  // required
  EXPECT_EQ(refusal({{"E", nan}}), "E");
  EXPECT_EQ(refusal({{"E", inf}}), "E");
  EXPECT_EQ(refusal({{"E", -1.0}}), "E");
  EXPECT_EQ(refusal({{"E", 1.0}, {"nu", 0.5}}), "nu");
  EXPECT_EQ(refusal({{"E", 1.0}, {"K", 2.0}}), "K");
}

TEST(Material, UpdatesBatchesComponentMajor) {
  const auto material = elastic_material(1e3, 0.3);
  const std::size_t n = 3;
  std::vector<double> F(9 * n), cauchy(9 * n);
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor f = Tensor::Identity() + 0.1 * static_cast<double>(p) * Tensor::Ones();
    for (int c = 0; c < 9; ++c) F[static_cast<std::size_t>(c) * n + p] = component(f, c);
  }
  const UpdateReport report = material->update(0, 1, n, F.data(), F.data(), nullptr, nullptr, cauchy.data());
  EXPECT_EQ(report.worst, ASSAY_GOOD);
  const double mu = 1e3 / 2.6, lambda = 1e3 * 0.3 / (1.3 * 0.4);
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor f = Tensor::Identity() + 0.1 * static_cast<double>(p) * Tensor::Ones();
    const double J = f.determinant();
    const Tensor expected =
        lambda * std::log(J) / J * Tensor::Identity() + mu / J * (f * f.transpose() - Tensor::Identity());  // (34)
    for (int c = 0; c < 9; ++c) {
      EXPECT_NEAR(cauchy[static_cast<std::size_t>(c) * n + p], component(expected, c), 1e-11);
    }
  }
}

TEST(Material, ReportsTheFirstPointThatFails) {
  std::vector<double> F(18), cauchy(18);
  for (std::size_t p = 0; p < 2; ++p) {
    for (const std::size_t d : {0, 4, 8}) F[2 * d + p] = 1;
  }
  F[1] = -1;  // F11 of the second point
  const UpdateReport report = elastic_material()->update(0, 1, 2, F.data(), F.data(), nullptr, nullptr, cauchy.data());
  EXPECT_EQ(report.worst, ASSAY_FAILED);
  EXPECT_EQ(report.worst_point, 1u);
  EXPECT_EQ(report.message, "det F <= 0");
}

TEST(Material, DoesNotTrustStatusAndStress) {
  static double stress;
  static std::int32_t answer;
  assay_material table = *elastic();
  table.update = [](void*, const assay_step*, std::size_t n, const double*, double*, double* cauchy,
                    std::int32_t* status, double*, char*) {
    std::fill_n(cauchy, 9 * n, 1.0);
    cauchy[8 * n + 1] = stress;  // 33 of the second point
    status[n - 1] = answer;
  };
  const Material material(&table, {{"E", 1.0}});
  const auto report_of = [&](double s, std::int32_t status) {
    stress = s;
    answer = status;
    std::vector<double> F(45, 1.0), cauchy(45);
    return material.update(0, 1, 5, F.data(), F.data(), nullptr, nullptr, cauchy.data());
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(report_of(1, ASSAY_GOOD).worst, ASSAY_GOOD);
  EXPECT_EQ(report_of(1, ASSAY_DOUBTFUL).worst, ASSAY_DOUBTFUL);
  for (const std::int32_t unknown : {7, -5}) {
    const UpdateReport report = report_of(1, unknown);
    EXPECT_EQ(report.worst, ASSAY_FAILED);
    EXPECT_EQ(report.worst_point, 4u);
    EXPECT_EQ(report.message,
              "the material returned the status " + std::to_string(unknown) + ", which is none of the ABI's");
  }
  for (const double bad : {nan, inf, -inf}) {
    EXPECT_EQ(report_of(bad, ASSAY_GOOD).worst, ASSAY_FAILED);
    EXPECT_EQ(report_of(bad, ASSAY_GOOD).worst_point, 1u);
  }
}

TEST(Material, TakesNoFactorOfAStepThatIsNone) {
  static double factor;
  assay_material table = *elastic();
  table.update = [](void*, const assay_step*, std::size_t n, const double*, double*, double* cauchy, std::int32_t*,
                    double* dt_factor, char*) {
    std::fill_n(cauchy, 9 * n, 1.0);
    *dt_factor = factor;
  };
  const Material material(&table, {{"E", 1.0}});
  const auto report_of = [&](double answer) {
    factor = answer;
    std::vector<double> F(9, 1.0), cauchy(9);
    return material.update(0, 1, 1, F.data(), F.data(), nullptr, nullptr, cauchy.data());
  };
  for (const double good : {0.25, 1.0, 2.0, 1e300}) EXPECT_EQ(report_of(good).worst, ASSAY_GOOD) << good;
  for (const double bad : {-1.0, -1e-300, std::nan("")}) {
    const UpdateReport report = report_of(bad);
    EXPECT_EQ(report.worst, ASSAY_FAILED) << bad;
    EXPECT_NE(report.message.find("the material returned a dt_factor that is "), std::string::npos) << report.message;
    EXPECT_NE(report.dt_factor, 0) << "it has not ended";
  }
}

TEST(Material, KnowsItsState) {
  const auto material = jaumann_material();
  EXPECT_EQ(material->state_size(), 9u);
  EXPECT_FALSE(material->path_independent());
  EXPECT_TRUE(elastic_material()->path_independent());
  std::vector<double> stress(18);
  for (std::size_t k = 0; k < stress.size(); ++k) stress[k] = static_cast<double>(k);
  EXPECT_EQ(material->initial_state(2, stress), stress);
  EXPECT_EQ(material->initial_state(1), std::vector<double>(9, 0.0));
}

TEST(Material, DoesNotTrustTheStatusOfItsBeginning) {
  assay_material table = *jaumann_table();
  table.initial_state = [](void*, size_t, const double*, double*) -> std::int32_t { return -7; };
  const Material material(&table, {});
  try {
    material.initial_state(1);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("returned the status -7, which is none of the ABI's"), std::string::npos)
        << error.what();
  }
}

TEST(Material, FillsDirectionsForTheModel) {
  assay_material table = *jaumann_table();
  const assay_state_variable state[] = {{"stress", "Pa", ASSAY_TENSOR, ASSAY_ROLE_PLAIN, ""},
                                        {"fibre", "1", ASSAY_VECTOR, ASSAY_ROLE_DIRECTION, ""}};
  table.state = state;
  table.state_count = 2;
  const Material material(&table, {});
  EXPECT_EQ(material.state_size(), 12u);
  const auto by_default = material.initial_state(1);
  EXPECT_EQ(std::vector<double>(by_default.end() - 3, by_default.end()), (std::vector<double>{1, 0, 0}));
  const std::vector<double> direction{0, 0.6, 0.8};
  const auto given = material.initial_state(1, {}, direction);
  EXPECT_EQ(std::vector<double>(given.end() - 3, given.end()), direction);
}

TEST(MaterialTable, DefectsAreNamed) {
  EXPECT_FALSE(defect_of(elastic()));
  EXPECT_TRUE(defect_of(nullptr));
  const auto defect = [](auto change) {
    assay_material table = *elastic();
    change(table);
    return defect_of(&table).value_or("none");
  };
  EXPECT_NE(defect([](auto& t) { t.abi_major = 2; }).find("ABI major 2"), std::string::npos);
  EXPECT_NE(defect([](auto& t) { t.struct_size = 8; }).find("8 bytes"), std::string::npos);
  EXPECT_NE(defect([](auto& t) { t.name = nullptr; }), "none");
  EXPECT_NE(defect([](auto& t) { t.update = nullptr; }), "none");
  EXPECT_NE(defect([](auto& t) { t.parameters = nullptr; }), "none");
  EXPECT_NE(defect([](auto& t) { t.state_count = 1; }), "none");
  EXPECT_EQ(defect([](auto& t) { t.struct_size += 64; }), "none");  // a younger table with more at its end
}

/// The rules of the header for what a table says of itself.
TEST(MaterialTable, ClaimsThatCannotBeAreNamed) {
  const auto of_parameters = [](std::vector<assay_parameter> all) {
    assay_material table = *elastic();
    table.parameters = all.data();
    table.parameter_count = static_cast<std::uint32_t>(all.size());
    return defect_of(&table).value_or("none");
  };
  const auto of_state = [](std::vector<assay_state_variable> all) {
    assay_material table = *elastic();
    table.state = all.data();
    table.state_count = static_cast<std::uint32_t>(all.size());
    table.initial_state = [](void*, size_t, const double*, double*) -> std::int32_t { return ASSAY_GOOD; };
    return defect_of(&table).value_or("none");
  };
  const auto claims = [](std::int32_t symmetry, std::uint32_t flags) {
    assay_material table = *elastic();
    table.symmetry = symmetry, table.flags = flags;
    return defect_of(&table).value_or("none");
  };
  EXPECT_EQ(of_parameters({{"K", "Pa", 1, 0, INFINITY, ""}, {"a[0]", "1", NAN, -1, 1, ""}}), "none");
  EXPECT_EQ(of_parameters({{"K", "Pa", 20, 0, 10, ""}}), "the default of its parameter 'K' lies outside the bounds");
  EXPECT_EQ(of_parameters({{"K", "Pa", 1, 10, 0, ""}}), "the lower bound of its parameter 'K' lies above the upper");
  EXPECT_EQ(of_parameters({{"K", "Pa", 1, NAN, 1, ""}}), "a bound of its parameter 'K' is not a number");
  EXPECT_NE(of_parameters({{"K", "Pa", 1, 0, 2, ""}, {"K", "Pa", 1, 0, 2, ""}}).find("named 'K'"), std::string::npos);
  for (const char* name : {"", "K = 1", "a,b", "K:", "E\n", "{E}"}) {
    EXPECT_NE(of_parameters({{name, "Pa", 1, 0, 2, ""}}).find("cannot stand in a key"), std::string::npos) << name;
  }
  EXPECT_EQ(of_state({{"D", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, ""}}), "none");
  EXPECT_NE(of_state({{"D", "1", ASSAY_SCALAR, 7, ""}}).find("unknown role"), std::string::npos);
  EXPECT_NE(of_state({{"D", "1", ASSAY_TENSOR, ASSAY_ROLE_DIRECTION, ""}}).find("no vector"), std::string::npos);
  EXPECT_NE(of_state({{"D", "1", 0, 0, ""}, {"D", "1", 0, 0, ""}}).find("named 'D'"), std::string::npos);
  EXPECT_EQ(claims(-77, 0), "its symmetry, -77, is unknown");
  EXPECT_EQ(claims(ASSAY_ISOTROPIC, 0xffffffffu), "its flags, 4294967295, hold unknown ones");
  assay_material table = *elastic();
  const std::string name(200, 'a');
  table.name = name.c_str();
  EXPECT_NE(defect_of(&table).value_or("none").find("more than 100 characters"), std::string::npos);
}

}  // namespace
}  // namespace assay::test_material
