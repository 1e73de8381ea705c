// SPDX-License-Identifier: BSD-3-Clause
// A path for a model of plane stress: no deformation out of the plane is prescribed, and the thickness is the host's.
#include <algorithm>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/membrane.hpp"
#include "drivers/path/path_result.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

bool leaves_plane(const PathTerm& term) { return term.i == 2 || term.j == 2; }

/// Whether the row says no more than that nothing happens out of the plane: one component that stays as at rest.
bool is_still(const PathRow& row) {
  if (row.quantity.terms.size() != 1 || row.value.type != PathFunction::Type::constant) return false;
  const PathTerm& term = row.quantity.terms.front();
  return row.value.value == (term.family == "F" && term.i == term.j ? term.factor : 0);
}

/// "e33 + 0.43 e11 + 0.43 e22", which is zero; in F alone of a constant thickness.
PathRow thickness_row_of(const std::string& letter, double thinning) {
  PathRow row;
  row.origin = PathRow::Origin::supplied;
  row.quantity = {letter + "33", {{letter, 2, 2}}};
  if (letter == "F") row.value.value = 1;
  for (int i = 0; thinning != 0 && i < 2; ++i) {
    const std::string name = letter + std::to_string(i + 1) + std::to_string(i + 1);
    row.quantity.terms.push_back({letter, i, i, thinning});
    row.quantity.text += " + " + (thinning == 1 ? "" : rounded_text(thinning, 4) + " ") + name;
  }
  return row;
}

PathRow held_row(const std::string& letter, int i, int j) {
  PathRow row;
  row.origin = PathRow::Origin::held;
  row.quantity = {letter + std::to_string(i + 1) + std::to_string(j + 1), {{letter, i, j}}};
  return row;
}

}  // namespace

PathScene path_of_plane_stress(const PathScene& scene, const adapters::ForeignModel& model, std::string& note) {
  const std::string of_model = "'" + model.name + "' is a model of plane stress (components: [3])";
  const double thinning = adapters::thinning_of(model);
  const std::string letter = letter_of(scene.deformation);
  const Location file{scene.file, 0, 0};
  if (scene.deformation == Deformation::gradient && thinning != 0) {
    throw InputError(file, "path.control",
                     "F does not go with a thickness that follows ln U: " + of_model + ". Prescribe e or L");
  }
  constexpr std::size_t out_of_plane[] = {2, 4, 5};  // of 11, 22, 33, 12, 13, 23
  if (std::ranges::any_of(out_of_plane, [&](std::size_t k) { return scene.initial_stress[k] != 0; }))
    throw InputError(file, "path.initial_stress", of_model + ", which has no stress 33, 13 or 23");
  if (scene.iso_error)
    throw InputError(file, "iso_error", "takes the model with face 3 free of stress, in three dimensions: " + of_model);
  PathScene own = scene;
  own.rows.clear();
  for (const PathRow& row : scene.rows) {
    const bool leaves = std::ranges::any_of(row.quantity.terms, leaves_plane);
    if (!leaves) own.rows.push_back(row);
    if (!leaves || is_still(row)) continue;
    throw InputError(row.where.file.empty() ? file : row.where, "path.control." + row.quantity.text,
                     "prescribes what is not in the plane: " + of_model +
                         ", whose stress 33 is zero and whose thickness follows from `thickness`");
  }
  own.rows.push_back(thickness_row_of(letter, thinning));
  note = "plane stress: the model knows the plane alone, and its thickness is that of `thickness`, " +
         own.rows.back().quantity.text + (letter == "F" ? " = 1" : " = 0");
  for (int i = 0; i < 2; ++i) {
    own.rows.push_back(held_row(letter, i, 2));
    if (scene.deformation != Deformation::logarithmic_strain) own.rows.push_back(held_row(letter, 2, i));
  }
  const std::size_t needed = scene.deformation == Deformation::logarithmic_strain ? 6 : 9;
  if (own.rows.size() != needed)
    throw InputError(file, "path.control", "has too few or too many rows in the plane: " + of_model);
  for (PathScene& stage : own.later) stage = path_of_plane_stress(stage, model, note);
  return own;
}

}  // namespace assay::drivers
