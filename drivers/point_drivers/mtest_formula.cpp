// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_formula.hpp"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "drivers/point_drivers/formula_translation.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

using OfOne = double (*)(double);
using OfTwo = double (*)(double, double);

const std::map<std::string, OfOne>& functions_of_one() {
  static const std::map<std::string, OfOne> functions{
      {"exp", std::exp},       {"exp2", std::exp2},
      {"expm1", std::expm1},   {"cbrt", std::cbrt},
      {"abs", std::fabs},      {"sqrt", std::sqrt},
      {"ln", std::log},        {"log", std::log},
      {"log10", std::log10},   {"log2", std::log2},
      {"log1p", std::log1p},   {"cosh", std::cosh},
      {"sinh", std::sinh},     {"tanh", std::tanh},
      {"acosh", std::acosh},   {"asinh", std::asinh},
      {"atanh", std::atanh},   {"sin", std::sin},
      {"cos", std::cos},       {"tan", std::tan},
      {"acos", std::acos},     {"asin", std::asin},
      {"atan", std::atan},     {"erf", std::erf},
      {"erfc", std::erfc},     {"tgamma", std::tgamma},
      {"lgamma", std::lgamma}, {"H", [](double x) { return x < 0 ? 0.0 : 1.0; }}};
  return functions;
}

const std::map<std::string, OfTwo>& functions_of_two() {
  static const std::map<std::string, OfTwo> functions{{"max", [](double a, double b) { return std::max(a, b); }},
                                                      {"min", [](double a, double b) { return std::min(a, b); }},
                                                      {"hypot", [](double a, double b) { return std::hypot(a, b); }},
                                                      {"atan2", std::atan2}};
  return functions;
}

}  // namespace

struct MtestFormula::Program {
  mu::Parser parser;
  std::vector<double> values;
};

MtestFormula::MtestFormula(const std::string& text, const Location& where) : program_(std::make_shared<Program>()) {
  const auto number_of_arguments = [](const std::string& name) {
    return functions_of_one().count(name) > 0 ? 1 : functions_of_two().count(name) > 0 ? 2 : 0;
  };
  const TranslatedFormula translated = translate_formula(text, where, number_of_arguments, mtest_functions());
  variables_ = translated.variables;
  try {
    mu::Parser& parser = program_->parser;
    parser.ClearFun();
    parser.ClearConst();
    for (const auto& [name, function] : functions_of_one()) parser.DefineFun(name, function);
    for (const auto& [name, function] : functions_of_two()) parser.DefineFun(name, function);
    parser.DefineInfixOprt("!", [](double x) { return x == 0 ? 1.0 : 0.0; });
    program_->values.resize(variables_.size());
    for (std::size_t i = 0; i < variables_.size(); ++i) parser.DefineVar(variable_word(i), &program_->values[i]);
    parser.SetExpr(translated.text);
    parser.Eval();  // the text is analysed now
  } catch (const mu::ParserError& error) {
    throw InputError(where, "", "'" + text + "' is no formula: " + error.GetMsg());
  }
}

double MtestFormula::value(const std::vector<double>& values) const {
  std::copy(values.begin(), values.end(), program_->values.begin());
  return program_->parser.Eval();
}

const std::vector<std::string>& mtest_functions() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"power"};
    for (const auto& each : functions_of_one()) all.push_back(each.first);
    for (const auto& each : functions_of_two()) all.push_back(each.first);
    std::sort(all.begin(), all.end());
    return all;
  }();
  return names;
}

}  // namespace assay::drivers
