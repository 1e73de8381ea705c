// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_evolutions.hpp"

#include <algorithm>
#include <set>

#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr const char* time_name = "t";
constexpr int longest_chain = 1000;  ///< of formulas that call each other

}  // namespace

void MtestEvolutions::add(const std::string& name, const FunctionOfTime& function, const Location& where) {
  if (name.empty()) throw InputError(where, "", "an empty name");
  const auto [place, is_new] = places_.emplace(name, where);
  if (!is_new)
    throw InputError(where, "", "'" + name + "' is there already, in line " + std::to_string(place->second.line));
  functions_.emplace(name, function);
}

void MtestEvolutions::add_unknown(const std::string& name, const Location& where) { add(name, {}, where); }

FunctionOfTime MtestEvolutions::of_formula(const std::string& text, const Location& where) {
  auto body = std::make_shared<FunctionOfTime::Body>();
  nodes_.push_back(std::make_unique<Node>(Node{MtestFormula(text, where), body, where, State::open}));
  return FunctionOfTime(body);
}

double MtestEvolutions::constant(const std::string& text, const Location& where) {
  Node node{MtestFormula(text, where), std::make_shared<FunctionOfTime::Body>(), where, State::open};
  bind(node, 0);
  if (!node.body->is_constant)
    throw InputError(where, "", "'" + text + "' depends on the time, where one number is wanted");
  return node.body->at(0);
}

void MtestEvolutions::resolve() {
  for (const auto& node : nodes_)
    if (node->state == State::open) bind(*node, 0);
}

void MtestEvolutions::bind(Node& node, int depth) {
  if (depth > longest_chain) throw InputError(node.where, "", "a chain of too many formulas");
  node.state = State::begun;
  std::vector<FunctionOfTime> arguments;
  std::set<double> knots;
  bool is_constant = true;
  for (const std::string& name : node.formula.variables()) {
    if (name == time_name) {
      is_constant = false;
      arguments.emplace_back();
      continue;
    }
    const auto found = functions_.find(name);
    if (found == functions_.end())
      throw InputError(node.where, "", unknown("name in a formula", name, names()), known_words(name, names()));
    if (!found->second)
      throw InputError(node.where, "", "'" + name + "' is computed by a library, and a formula cannot hold it");
    Node* other = node_of(found->second);
    if (other && other->state == State::begun)
      throw InputError(node.where, "", "'" + name + "' calls itself through this formula");
    if (other && other->state == State::open) bind(*other, depth + 1);
    arguments.push_back(found->second);
    is_constant = is_constant && found->second.is_constant();
    knots.insert(found->second.knots().begin(), found->second.knots().end());
  }
  node.body->knots.assign(knots.begin(), knots.end());
  node.body->is_constant = is_constant;
  node.body->at = [formula = node.formula, arguments](double time) {
    std::vector<double> values;
    for (const FunctionOfTime& each : arguments) values.push_back(each ? each(time) : time);
    return formula.value(values);
  };
  if (is_constant) node.body->at = [value = node.body->at(0)](double) { return value; };
  node.state = State::bound;
}

MtestEvolutions::Node* MtestEvolutions::node_of(const FunctionOfTime& function) {
  const auto found = std::find_if(nodes_.begin(), nodes_.end(),
                                  [&](const auto& node) { return FunctionOfTime(node->body) == function; });
  return found == nodes_.end() ? nullptr : found->get();
}

const FunctionOfTime* MtestEvolutions::find(const std::string& name) const {
  const auto found = functions_.find(name);
  return found == functions_.end() ? nullptr : &found->second;
}

std::vector<std::string> MtestEvolutions::names() const {
  return mapped(functions_, [](const auto& each) { return each.first; });
}

}  // namespace assay::drivers
