// SPDX-License-Identifier: BSD-3-Clause
// What an MTest file imposes, where it begins, and at which times it stops.
#include <algorithm>

#include "drivers/point_drivers/mtest_reading.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

using Quantity = MtestImposed::Quantity;

char letter_of(Quantity quantity) {
  return quantity == Quantity::strain ? 'E' : quantity == Quantity::stress ? 'S' : 'F';
}

/// What a component is that is only called a gradient or a thermodynamic force.
Quantity quantity_of(const MtestHypothesis& hypothesis, const std::string& component, Quantity general) {
  if (general == Quantity::force)
    return is_one_of(component, component_names(hypothesis, 'S')) ? Quantity::stress : general;
  if (is_one_of(component, component_names(hypothesis, 'E'))) return Quantity::strain;
  return is_one_of(component, component_names(hypothesis, 'F')) ? Quantity::deformation_gradient : general;
}

void check_component(MtestReading& reading, const MtestImposed& imposed) {
  if (imposed.quantity == Quantity::gradient || imposed.quantity == Quantity::force) return;
  const std::vector<std::string> known = component_names(reading.hypothesis(), letter_of(imposed.quantity));
  if (is_one_of(imposed.component, known)) return;
  reading.tokens.refuse(imposed.where,
                        unknown("component", imposed.component, known) + " of the hypothesis " + reading.out.hypothesis,
                        joined(known));
}

void refuse_options(MtestTokens& tokens) {
  if (tokens.next_is("{")) tokens.refuse("events that switch what is imposed on and off are not served");
}

void read_imposed(MtestReading& reading, Quantity quantity) {
  MtestTokens& tokens = reading.tokens;
  const std::string type = read_type(reading);
  MtestImposed imposed;
  imposed.where = tokens.where();
  imposed.component = tokens.text();
  const bool is_general = quantity == Quantity::gradient || quantity == Quantity::force;
  imposed.quantity = is_general ? quantity_of(reading.hypothesis(), imposed.component, quantity) : quantity;
  check_component(reading, imposed);
  imposed.value = read_function(reading, type);
  refuse_options(tokens);
  reading.evolutions.add(imposed.component, imposed.value, imposed.where);
  reading.out.imposed.push_back(imposed);
  tokens.expect(";");
}

void read_initial(MtestReading& reading, std::vector<double> MtestFile::*values) {
  MtestTokens& tokens = reading.tokens;
  if (!(reading.out.*values).empty()) tokens.refuse("initial values are there already");
  reading.out.*values = read_numbers(reading);
  tokens.expect(";");
}

/// Binds a constraint when all names are known: the formula's variables are components, evolutions, or the time.
void bind_constraint(MtestReading& reading, std::size_t number, const MtestFormula& formula) {
  MtestConstraint& constraint = reading.out.constraints[number];
  const MtestHypothesis& hypothesis = reading.hypothesis();
  std::vector<FunctionOfTime> arguments;
  for (const std::string& name : formula.variables()) {
    const FunctionOfTime* function = name == "t" ? nullptr : reading.evolutions.find(name);
    arguments.push_back(function ? *function : FunctionOfTime());
    if (function || name == "t") continue;
    const bool is_component = std::ranges::any_of(
        std::string("ESF"), [&](char letter) { return is_one_of(name, component_names(hypothesis, letter)); });
    if (!is_component)
      throw InputError(constraint.where, "@NonLinearConstraint",
                       unknown("name in a formula", name, reading.evolutions.names()),
                       known_words(name, reading.evolutions.names()));
    constraint.components.push_back(name);
  }
  constraint.value = [formula, arguments](const std::vector<double>& components, double time) {
    std::vector<double> values;
    std::size_t next = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const bool is_time = formula.variables()[i] == "t";
      values.push_back(is_time ? time : arguments[i] ? arguments[i](time) : components[next++]);
    }
    return formula.value(values);
  };
}

void read_constraint(MtestReading& reading) {
  static const std::vector<std::string> stresses{"Stress", "ThermodynamicForce"};
  static const std::vector<std::string> strains{"Strain", "DeformationGradient", "Gradient"};
  MtestTokens& tokens = reading.tokens;
  MtestConstraint constraint;
  const Location of_type = tokens.where();
  const std::string type = read_type(reading);
  constraint.is_of_stress = is_one_of(type, stresses);
  if (!constraint.is_of_stress && !is_one_of(type, strains))
    tokens.refuse(of_type, "a constraint is measured as a strain or a stress",
                  joined(strains) + ", " + joined(stresses));
  constraint.where = inside_quotes(tokens);
  constraint.formula = tokens.text();
  refuse_options(tokens);
  tokens.expect(";");
  const MtestFormula formula(constraint.formula, constraint.where);
  reading.out.constraints.push_back(std::move(constraint));
  const std::size_t number = reading.out.constraints.size() - 1;
  reading.afterwards.emplace_back([&reading, number, formula] { bind_constraint(reading, number, formula); });
}

void read_all_times(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  const Location where = tokens.where();
  if (!reading.out.times.empty()) tokens.refuse("the times are there already");
  const std::string type = read_type(reading);
  if (type == "file" || type == "data") {
    const std::string file = mtest_path(reading.out.file, tokens.text());
    if (tokens.word() != "using") tokens.refuse(where, "write <data> 'file' using 1, the column of times");
    reading.out.times = read_column(reading, file);
    if (std::ranges::adjacent_find(reading.out.times, std::greater_equal<>()) != reading.out.times.end())
      tokens.refuse(where, "the times of '" + file + "' must ascend");
  } else if (type.empty() || type == "array") {
    reading.out.times = read_times(reading);
  } else {
    tokens.refuse(where, "'" + type + "' is no kind of times", "array, data, file");
  }
  if (reading.out.times.size() < 2) tokens.refuse(where, "at least two times are needed");
  tokens.expect(";");
}

}  // namespace

void add_loading_keywords(MtestHandlers& handlers) {
  const auto imposed = [](Quantity quantity) {
    return [quantity](MtestReading& reading) { read_imposed(reading, quantity); };
  };
  handlers["@ImposedStrain"] = imposed(Quantity::strain);
  handlers["@ImposedDeformationGradient"] = imposed(Quantity::deformation_gradient);
  handlers["@ImposedStress"] = imposed(Quantity::stress);
  handlers["@ImposedDrivingVariable"] = handlers["@ImposedGradient"] = imposed(Quantity::gradient);
  handlers["@ImposedThermodynamicForce"] = imposed(Quantity::force);
  for (const char* keyword : {"@Strain", "@DeformationGradient", "@DrivingVariable", "@Gradient"})
    handlers[keyword] = [](MtestReading& reading) { read_initial(reading, &MtestFile::initial_gradient); };
  for (const char* keyword : {"@Stress", "@ThermodynamicForce"})
    handlers[keyword] = [](MtestReading& reading) { read_initial(reading, &MtestFile::initial_force); };
  for (const char* keyword : {"@ImposedOpeningDisplacement", "@ImposedCohesiveForce", "@OpeningDisplacement",
                              "@CohesiveForce", "@OpeningDisplacementEpsilon", "@CohesiveForceEpsilon"})
    handlers[keyword] = [](MtestReading& reading) { reading.tokens.refuse("cohesive zone models are not served"); };
  handlers["@NonLinearConstraint"] = read_constraint;
  handlers["@Times"] = read_all_times;
}

}  // namespace assay::drivers
