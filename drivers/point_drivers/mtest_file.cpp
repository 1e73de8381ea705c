// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_file.hpp"

#include <algorithm>
#include <filesystem>

#include "drivers/point_drivers/mtest_reading.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

using Quantity = MtestImposed::Quantity;

const MtestHandlers& mtest_handlers() {
  static const MtestHandlers handlers = [] {
    MtestHandlers all;
    add_behaviour_keywords(all);
    add_variable_keywords(all);
    add_loading_keywords(all);
    add_comparison_keywords(all);
    add_setting_keywords(all);
    return all;
  }();
  return handlers;
}

/// Reads one keyword and what belongs to it.
void read_keyword(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  tokens.set_keyword("");
  if (tokens.take(";")) return;
  const MtestToken token = tokens.next();
  const auto handler = mtest_handlers().find(token.text);
  if (handler == mtest_handlers().end() || token.kind != MtestToken::Kind::word) {
    const bool is_keyword = token.kind == MtestToken::Kind::word && token.text[0] == '@';
    tokens.refuse(token.where,
                  is_keyword ? unknown("keyword", token.text, mtest_keywords())
                             : "a keyword as @Times belongs here, found " + token.text,
                  known_words(token.text, mtest_keywords(), "MTest's documentation"));
  }
  tokens.set_keyword(token.text);
  try {
    handler->second(reading);
  } catch (const InputError& error) {
    const std::string place = error.where().text() + ": ", line = error.what();
    if (!error.key().empty() || !line.starts_with(place)) throw;
    throw InputError(error.where(), token.text, line.substr(place.size()));
  }
}

bool has_quantity(const MtestFile& file, Quantity quantity) {
  return std::ranges::any_of(file.imposed, [&](const MtestImposed& each) { return each.quantity == quantity; });
}

/// Throws where what is imposed, or the number of initial values, belongs to two kinds of behaviours.
MtestKinematics kinematics_of(const MtestReading& reading) {
  const MtestFile& file = reading.out;
  const bool small = has_quantity(file, Quantity::strain), finite = has_quantity(file, Quantity::deformation_gradient);
  if (small && finite)
    throw InputError(file.imposed.back().where, "", "strains and deformation gradients are imposed in one file");
  if (has_quantity(file, Quantity::gradient)) return MtestKinematics::other;
  const std::size_t count = file.initial_gradient.size();
  const MtestHypothesis& hypothesis = reading.hypothesis();
  if (small) return MtestKinematics::small_strain;
  if (finite) return MtestKinematics::finite_strain;
  if (count == 0 || hypothesis.symmetric.size() == hypothesis.general.size()) return MtestKinematics::unknown;
  if (count == hypothesis.general.size()) return MtestKinematics::finite_strain;
  return count == hypothesis.symmetric.size() ? MtestKinematics::small_strain : MtestKinematics::other;
}

void check_initial_values(const MtestReading& reading) {
  const MtestFile& file = reading.out;
  const MtestHypothesis& hypothesis = reading.hypothesis();
  const auto check = [&](const char* keyword, std::size_t count, std::size_t wanted) {
    if (count == 0 || count == wanted) return;
    throw InputError({file.file, 0, 0}, keyword,
                     "has " + std::to_string(count) + " initial values, where the hypothesis " + hypothesis.name +
                         " has " + std::to_string(wanted) + " components");
  };
  if (file.kinematics == MtestKinematics::small_strain)
    check("@Strain", file.initial_gradient.size(), hypothesis.symmetric.size());
  if (file.kinematics == MtestKinematics::finite_strain)
    check("@DeformationGradient", file.initial_gradient.size(), hypothesis.general.size());
  if (file.kinematics == MtestKinematics::small_strain || file.kinematics == MtestKinematics::finite_strain)
    check("@Stress", file.initial_force.size(), hypothesis.symmetric.size());
}

}  // namespace

MtestFile mtest_from_text(const std::string& text, const std::string& file, const MtestSurroundings& surroundings) {
  MtestReading reading{{text, file, surroundings.placeholders}, {}, {}, {}};
  reading.out.file = file;
  for (const auto& [name, value] : surroundings.parameters)
    reading.evolutions.add(name, constant_in_time(value), {file, 0, 0});
  while (!reading.tokens.at_end()) read_keyword(reading);
  reading.evolutions.resolve();
  for (const auto& each : reading.afterwards) each();
  MtestFile& out = reading.out;
  if (out.behaviour.function.empty()) throw InputError({file, 0, 0}, "@Behaviour", "required and not given");
  if (out.times.empty()) throw InputError({file, 0, 0}, "@Times", "required and not given");
  out.evolutions = reading.evolutions.all();
  out.kinematics = kinematics_of(reading);
  check_initial_values(reading);
  return std::move(out);
}

MtestFile read_mtest(const std::string& file, const MtestSurroundings& surroundings) {
  return mtest_from_text(read_bytes(file), file, surroundings);
}

const std::vector<std::string>& mtest_keywords() {
  static const std::vector<std::string> names = mapped(mtest_handlers(), [](const auto& each) { return each.first; });
  return names;
}

std::string mtest_path(const std::string& mtest_file, const std::string& name) {
  const std::filesystem::path path(name);
  if (path.is_absolute()) return name;
  return (std::filesystem::path(mtest_file).parent_path() / path).lexically_normal().string();
}

}  // namespace assay::drivers
