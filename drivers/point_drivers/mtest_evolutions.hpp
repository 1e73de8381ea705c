// SPDX-License-Identifier: BSD-3-Clause
// The functions of time of an MTest file by name, and the formulas that call them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "drivers/point_drivers/function_of_time.hpp"
#include "drivers/point_drivers/mtest_formula.hpp"

namespace assay::drivers {

/// A formula may name what stands behind it in the file. resolve() binds it; before, only what is constant is known.
class MtestEvolutions {
 public:
  /// Throws InputError where the name is there already.
  void add(const std::string& name, const FunctionOfTime& function, const Location& where);
  /// Of a value that a library computes: no formula may name it.
  void add_unknown(const std::string& name, const Location& where);

  /// A function that can be evaluated after resolve(). where: of the first character of the text.
  FunctionOfTime of_formula(const std::string& text, const Location& where);
  /// The value now, of a formula whose variables are constant.
  double constant(const std::string& text, const Location& where);

  /// Binds all formulas. Throws InputError at a variable that is not there, and at a formula that calls itself.
  void resolve();

  const std::map<std::string, FunctionOfTime>& all() const { return functions_; }
  /// Null of a name that is not there.
  const FunctionOfTime* find(const std::string& name) const;
  /// The names, for messages.
  std::vector<std::string> names() const;

 private:
  enum class State { open, begun, bound };
  struct Node {
    MtestFormula formula;
    std::shared_ptr<FunctionOfTime::Body> body;
    Location where;
    State state = State::open;
  };

  /// depth: how many formulas call it.
  void bind(Node& node, int depth);
  /// The node of a function that is a formula; null of another.
  Node* node_of(const FunctionOfTime& function);

  std::map<std::string, FunctionOfTime> functions_;  ///< empty ones: a library computes them
  std::map<std::string, Location> places_;
  std::vector<std::unique_ptr<Node>> nodes_;
};

}  // namespace assay::drivers
