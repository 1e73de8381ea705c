// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/niemunis_terms.hpp"

#include <cmath>
#include <functional>
#include <map>

#include "drivers/point_drivers/niemunis_lines.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

struct PointState {
  const Six& stress;
  const Six& strain;
  const std::vector<double>& state;
};
using Quantity6 = std::function<double(const PointState&)>;

const std::map<std::string, Quantity6>& exit_quantities() {
  static const std::map<std::string, Quantity6> all = [] {
    std::map<std::string, Quantity6> made;
    const char* ends[] = {"1", "2", "3", "12", "13", "23"};
    for (std::size_t i = 0; i < 6; ++i) {
      made[std::string("s") + ends[i]] = [i](const PointState& at) { return at.stress[i]; };
      made[std::string(i < 3 ? "e" : "g") + ends[i]] = [i](const PointState& at) { return at.strain[i]; };
    }
    for (std::size_t i = 0; i < 9; ++i)
      made["v" + std::to_string(i + 1)] = [i](const PointState& at) { return i < at.state.size() ? at.state[i] : 0; };
    const auto sum = [](const Six& v) { return v[0] + v[1] + v[2]; };
    made["p"] = [sum](const PointState& at) { return -sum(at.stress) / 3; };
    made["P"] = [sum](const PointState& at) { return -sum(at.stress) / std::sqrt(3.0); };
    made["q"] = made["Q"] = [](const PointState& at) { return at.stress[2] - at.stress[0]; };
    made["ev"] = [sum](const PointState& at) { return -sum(at.strain); };
    made["eP"] = [sum](const PointState& at) { return -sum(at.strain) / std::sqrt(3.0); };
    made["eq"] = [](const PointState& at) { return (at.strain[2] - at.strain[0]) * 2 / 3; };
    made["eQ"] = [](const PointState& at) { return (at.strain[2] - at.strain[0]) * std::sqrt(2.0 / 3); };
    return made;
  }();
  return all;
}

/// Takes a sum apart, from the left.
class TermReader {
 public:
  TermReader(std::string_view text, const Location& where) : text_(text), where_(where) {}

  Location place(std::size_t at) const {
    Location place = where_;
    place.column += static_cast<int>(at);
    return place;
  }
  [[noreturn]] void refuse(const std::string& what, const std::string& known = {}) const {
    throw InputError(place(at_), "", what, known);
  }
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size()); }
  bool at_end() {
    skip_blanks();
    return at_ == text_.size();
  }
  bool take(char sign) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != sign) return false;
    ++at_;
    return true;
  }

  /// [sign] [number *] name. All but the first term need the sign.
  NiemunisExit::Term term(const std::vector<std::string>& known) {
    NiemunisExit::Term term;
    if (take('-')) {
      term.factor = -1;
    } else if (!take('+') && has_term_) {
      refuse("a sign is missing: + or -");
    }
    has_term_ = true;
    skip_blanks();
    if (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) {
      term.factor *= number();
      if (!take('*')) refuse("'*' is missing between the factor and the name");
      skip_blanks();
    }
    std::size_t end = at_;
    while (end < text_.size() && is_letter_or_digit(text_[end])) ++end;
    term.quantity = text_.substr(at_, end - at_);
    if (term.quantity.empty()) refuse("a name is missing", joined(known));
    if (!is_one_of(term.quantity, known)) refuse(unknown("name", term.quantity, known), joined(known));
    at_ = end;
    return term;
  }

  double number() {
    skip_blanks();
    std::size_t end = at_;
    if (end < text_.size() && (text_[end] == '-' || text_[end] == '+')) ++end;
    while (end < text_.size() &&
           (is_letter_or_digit(text_[end]) || text_[end] == '.' ||
            ((text_[end] == '-' || text_[end] == '+') && std::string_view("eEdD").find(text_[end - 1]) != text_.npos)))
      ++end;
    const double value = niemunis_number({std::string(text_.substr(at_, end - at_)), place(at_)});
    at_ = end;
    return value;
  }

 private:
  std::string_view text_;
  Location where_;
  std::size_t at_ = 0;
  bool has_term_ = false;
};

const std::vector<std::string>& restricted_names() {
  static const std::vector<std::string> names{"sd1", "sd2", "sd3", "sd4", "sd5", "sd6",
                                              "ed1", "ed2", "ed3", "ed4", "ed5", "ed6"};
  return names;
}

}  // namespace

const std::vector<std::string>& niemunis_quantities() {
  static const std::vector<std::string> names = mapped(exit_quantities(), [](const auto& each) { return each.first; });
  return names;
}

bool niemunis_exits(const NiemunisExit& exit, const Six& stress, const Six& strain, const std::vector<double>& state) {
  double sum = 0;
  for (const NiemunisExit::Term& term : exit.terms)
    sum += term.factor * exit_quantities().at(term.quantity)({stress, strain, state});
  return exit.above ? sum > exit.bound : sum < exit.bound;
}

NiemunisExit read_exit(std::string_view text, const Location& where) {
  TermReader reader(text, where);
  NiemunisExit exit;
  for (;;) {
    exit.terms.push_back(reader.term(niemunis_quantities()));
    exit.above = reader.take('>');
    if (exit.above || reader.take('<')) break;
    if (reader.at_end()) reader.refuse("a condition needs > or <");
  }
  exit.bound = reader.number();
  return exit;
}

void read_restriction(std::string_view text, const Location& where, std::size_t equation,
                      NiemunisRestrictions& restrictions) {
  TermReader reader(text.substr(0, text.find_first_of("#!")), where);
  while (!reader.take('=')) {
    if (reader.at_end()) reader.refuse("a restriction needs '='");
    const NiemunisExit::Term term = reader.term(restricted_names());
    const std::size_t name = index_of(term.quantity, restricted_names());
    (name < 6 ? restrictions.on_stress : restrictions.on_strain)[equation][name % 6] += term.factor;
  }
  const bool minus = reader.take('-');
  restrictions.right[equation] = minus ? -reader.number() : reader.number();
}

}  // namespace assay::drivers
