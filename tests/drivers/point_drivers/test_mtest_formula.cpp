// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_formula.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "drivers/text/numbers.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_mtest_formula {
namespace {

double value(const std::string& text) { return MtestFormula(text, {"a.mtest", 2, 10}).value({}); }

std::string refused(const std::string& text) {
  return refusal_of([&] { MtestFormula(text, {"a.mtest", 2, 10}); });
}

TEST(MtestFormula, PowersBindClosestAndFromTheLeft) {
  EXPECT_EQ(value("2**3**2"), 64);
  EXPECT_EQ(value("-2**2"), -4);
  EXPECT_EQ(value("2**-1"), 0.5);
  EXPECT_EQ(value("3*2**2"), 12);
  EXPECT_EQ(value("power<3>(2) + power<-1>(4)"), 8.25);
  EXPECT_EQ(value("1-2-3"), -4);
  EXPECT_EQ(value("8/2/2"), 2);
  EXPECT_EQ(value("2*-3"), -6);
  EXPECT_EQ(value("2 - -3"), 5);
}

TEST(MtestFormula, FunctionsAreThoseOfMtest) {
  EXPECT_EQ(value("H(0)+H(-1e-9)+H(2)"), 2);
  EXPECT_EQ(value("log(exp(1))"), std::log(std::exp(1.0)));
  EXPECT_EQ(value("ln(2)"), std::log(2.0));
  EXPECT_EQ(value("max(1, min(5, 3))"), 3);
  EXPECT_EQ(value("atan2(1,2)+hypot(3,4)"), std::atan2(1, 2) + 5);
  EXPECT_EQ(value("cbrt(8) + log10(100)"), std::cbrt(8.0) + 2);
}

TEST(MtestFormula, ConditionsChoose) {
  const MtestFormula formula("x < (1/2) ? 10 : (x>=2 && !(y==3) ? 20 : 30*x)", {});
  EXPECT_EQ(formula.value({0.25, 3}), 10);
  EXPECT_EQ(formula.value({2, 4}), 20);
  EXPECT_EQ(formula.value({2, 3}), 60);
  EXPECT_EQ(refused("x < 1 ? 1 : x < 2 ? 2 : 3"),
            "a.mtest:2:28: formula 'x < 1 ? 1 : x < 2 ? 2 : 3': a condition within a condition: write brackets");
}

TEST(MtestFormula, NamesHoldIndicesAndScopes) {
  const MtestFormula formula("2*v[12]X - Law::k + $3 + µ", {});
  EXPECT_EQ(formula.variables(), (std::vector<std::string>{"v[12]X", "Law::k", "$3", "µ"}));
  EXPECT_EQ(formula.value({5, 3, 2, 1}), 10);
}

TEST(MtestFormula, WhatIsWrongIsNamedAtItsColumn) {
  const auto line = [](const char* column, const std::string& formula, const std::string& what) {
    return "a.mtest:2:" + std::string(column) + ": formula '" + formula + "': " + what;
  };
  EXPECT_EQ(refused("1 +"), line("13", "1 +", "a value is missing"));
  EXPECT_EQ(refused(""), line("10", "", "a value is missing"));
  EXPECT_EQ(refused("1 2"), line("12", "1 2", "an operator is missing"));
  EXPECT_EQ(refused("(1"), line("10", "(1", "'(' without ')'"));
  EXPECT_EQ(refused("1)"), line("11", "1)", "')' without '('"));
  EXPECT_EQ(refused("2^3"), line("11", "2^3", "a power is written **"));
  EXPECT_EQ(refused("1.2.3"), line("10", "1.2.3", "'1.2.3' is no number"));
  EXPECT_EQ(refused("exp"), line("10", "exp", "the function exp needs brackets"));
  EXPECT_EQ(refused("max(1)"), line("15", "max(1)", "max has 2 arguments"));
  EXPECT_EQ(refused("exp(1,2)"), line("15", "exp(1,2)", "exp has fewer arguments"));
  EXPECT_EQ(refused("a[x]"), line("11", "a[x]", "'[' without an index"));
  EXPECT_EQ(refused("a && b || c"), line("17", "a && b || c", "&& and || meet: write brackets"));
  EXPECT_EQ(refused("diff(t,t)"), line("10", "diff(t,t)", "derivatives are not served: write the derivative out"));
  EXPECT_NE(refused("sqr(2)").find("unknown function (nearest: sqrt)"), std::string::npos) << refused("sqr(2)");
  EXPECT_NE(refused(std::string(5000, '(')).find("too many brackets"), std::string::npos);
}

/// A formula with the value that it must have, of variables x and y.
struct Made {
  std::string text;
  double value;
  int rank;  ///< how closely its operator binds: 0 sum, 1 product, 2 power, 3 a single value
};

class Maker {
 public:
  explicit Maker(unsigned seed) : random_(seed) {}
  static constexpr double x = 0.75, y = 1.5;

  Made make(int depth) {
    switch (depth <= 0 ? pick(3) : pick(9)) {
      case 0:
        return {"x", x, 3};
      case 1:
        return {"y", y, 3};
      case 2: {
        const double number = pick(1000) / 64.0;
        return {number_text(number), number, 3};
      }
      case 3:
        return joined(make(depth - 1), "+", make(depth - 1), 0, [](double a, double b) { return a + b; });
      case 4:
        return joined(make(depth - 1), " - ", make(depth - 1), 0, [](double a, double b) { return a - b; });
      case 5:
        return joined(make(depth - 1), "*", make(depth - 1), 1, [](double a, double b) { return a * b; });
      case 6: {
        const Made base = make(depth - 1);
        return {closed(base, 2) + "**2", std::pow(base.value, 2), 2};
      }
      case 7: {
        const Made inner = make(depth - 1);
        return {"sin( " + inner.text + ")", std::sin(inner.value), 3};
      }
      default: {
        const Made a = make(depth - 1), b = make(depth - 1);
        return {"min(" + a.text + "," + b.text + ")", std::min(a.value, b.value), 3};
      }
    }
  }

 private:
  int pick(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }
  static std::string closed(const Made& made, int rank) { return made.rank < rank ? "(" + made.text + ")" : made.text; }
  static Made joined(const Made& a, const std::string& sign, const Made& b, int rank,
                     const std::function<double(double, double)>& of) {
    return {closed(a, rank) + sign + closed(b, rank + 1), of(a.value, b.value), rank};
  }

  std::mt19937 random_;
};

TEST(MtestFormula, AnyFormulaHasItsValue) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    const Made made = Maker(seed).make(5);
    const MtestFormula formula(made.text, {});
    std::vector<double> values;
    for (const std::string& name : formula.variables()) values.push_back(name == "x" ? Maker::x : Maker::y);
    EXPECT_NEAR(formula.value(values), made.value, 1e-12 * (1 + std::abs(made.value))) << made.text;
  }
}

TEST(MtestFormula, AnyTextIsTakenOrRefusedInOneLine) {
  const std::string signs = "xy12.e+-*/()<>=!&|?:,[] $";
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (unsigned length = random() % 12; length > 0; --length) text += signs[random() % signs.size()];
    const std::string line = refused(text);
    EXPECT_EQ(line.find('\n'), line.npos) << text;
    EXPECT_TRUE(line == "accepted" || line.starts_with("a.mtest:2:")) << line;
  }
}

}  // namespace
}  // namespace assay::drivers::test_mtest_formula
