// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/exported_force.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/export/force_sources.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/stability/tangent_modulus.hpp"

namespace assay::drivers {

ForcePieces exported_pieces(const ExportedProblem& problem, const std::string& target, bool quasi_static) {
  constexpr double of_table = 10;  // b has slopes of what is tabulated to force.tolerance
  ForceFit fit;
  fit.end = problem.end, fit.quasi_static = quasi_static;
  fit.asked_by = "--to " + target;
  const double coarse = of_table * problem.scene.force.tolerance;
  if (coarse <= fit.tolerance) return fit_force(*problem.exact, fit);
  try {
    return fit_force(*problem.exact, fit);
  } catch (const InputError&) {  // what is tabulated may have steps of the size of its error
    fit.tolerance = coarse;
    return fit_force(*problem.exact, fit);
  }
}

namespace {

/// Absent where there are none: another motion, a model with kinks, a force that is zero.
std::optional<ForcePieces> pieces_if_any(const ExportedProblem& problem, bool quasi_static) {
  if (!fault_of_pieces(problem.scene).empty()) return std::nullopt;
  try {
    return exported_pieces(problem, "", quasi_static);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::string add_force_sources(const ExportedProblem& problem, Deck& deck) {
  const auto pieces = pieces_if_any(problem, problem.quasi_static);
  if (!pieces) return {};
  for (const auto language : {ForceLanguage::c, ForceLanguage::fortran, ForceLanguage::python})
    for (const auto at : {ForceCoordinates::current, ForceCoordinates::reference})
      deck.files[std::string("vortex_force/") + (at == ForceCoordinates::current ? "current/" : "reference/") +
                 force_file(language)] = force_source(language, *pieces, at, problem.scene.title);
  return filled_template("force", "sources.md", {{"PIECES", pieces_words(*pieces)}});
}

std::string add_abaqus_routines(const ExportedProblem& problem, Deck& deck) {
  const auto at_rest = pieces_if_any(problem, true);
  if (!at_rest) return {};
  const auto put = [&](AbaqusRoutine routine, const char* file, const ForcePieces& pieces) {
    deck.files[file] = abaqus_force(routine, pieces, problem.density, problem.scene.title);
    return std::string("- `") + file + "`: " + (routine == AbaqusRoutine::dload ? "`DLOAD`" : "`VDLOAD`") +
           " for Abaqus/" + (routine == AbaqusRoutine::dload ? "Standard, quasi-static" : "Explicit") + "\n";
  };
  std::string files = put(AbaqusRoutine::dload, "vortex_dload.f", *at_rest), words = pieces_words(*at_rest);
  if (!problem.quasi_static) {
    if (const auto moving = pieces_if_any(problem, false))
      files += put(AbaqusRoutine::vdload, "vortex_vdload.f", *moving);
  }
  return filled_template("force", "abaqus.md", {{"FILES", files}, {"PIECES", words}});
}

std::string fault_of_expressions(const ExportedProblem& problem, const std::string& code) {
  if (problem.quasi_static)
    return code + " has inertia: leave force.quasi_static out, or use --to nodal-loads for a code that has none";
  return fault_of_pieces(problem.scene);
}

std::string pieces_words(const ForcePieces& pieces) {
  const std::size_t count = pieces.pieces.size();
  return "The expressions are polynomials in R and t, " + std::to_string(pieces.numbers()) + " numbers in " +
         std::to_string(count) + (count == 1 ? " piece" : " pieces") + ". Their largest error is " +
         rounded_text(pieces.error, 2) + " of the largest b, " + rounded_text(pieces.largest, 4) + " m/s2.";
}

namespace {

double least_steps(const ExportedProblem& problem, double h, double courant) {
  return problem.end * problem.wave_speed / (courant * h);
}

ExportedSteps steps_every(const ExportedProblem& problem, int every, double least) {
  const int outputs = std::max(1, static_cast<int>(std::ceil(least / every)));
  return {outputs * every, every, problem.end / (outputs * every)};
}

}  // namespace

ExportedSteps exported_steps(const ExportedProblem& problem, double h, double courant) {
  const double least = least_steps(problem, h, courant);
  return steps_every(problem, std::max(1, static_cast<int>(std::lround(least / exported_outputs))), least);
}

ExportedSteps steps_of_outputs(const ExportedProblem& problem, double h, double courant) {
  const int every = std::max(1, static_cast<int>(std::ceil(least_steps(problem, h, courant) / exported_outputs)));
  return steps_every(problem, every, every * exported_outputs);
}

std::optional<RestModuli> rest_moduli(const Material& material) {
  constexpr double dt = 1e-3;          // of no meaning for a function of F
  constexpr double difference = 1e-6;  // of differences, relative
  if (!material.is_function_of_F()) return std::nullopt;
  const TangentModulus A = probe_tangent_modulus(material, 0, dt, Tensor::Identity(), material.initial_state(1));
  const auto at = [&](int i, int J, int k, int L) { return A(3 * i + J, 3 * k + L); };
  const double shear = at(0, 1, 0, 1), lambda = at(0, 0, 1, 1), scale = std::abs(at(0, 0, 0, 0));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double expected = i == j ? lambda + 2 * shear : lambda;
      if (std::abs(at(i, i, j, j) - expected) > difference * scale) return std::nullopt;
      if (i != j && std::abs(at(i, j, i, j) - shear) > difference * scale) return std::nullopt;
    }
  if (!(shear > 0)) return std::nullopt;
  return RestModuli{lambda + 2 * shear / 3, shear};
}

}  // namespace assay::drivers
