// SPDX-License-Identifier: BSD-3-Clause
// From what a scene says of its material to one that can be run.
#pragma once

#include <string>
#include <vector>

#include "drivers/material/material_description.hpp"
#include "drivers/scene/scene.hpp"
#include "drivers/system/input_error.hpp"
#include "harness/material/material.hpp"

namespace assay::drivers {

struct ResolvedMaterial {
  Material material;
  MaterialChoice choice;         ///< all parameters and the density filled in: what resolved.yaml should hold
  std::string library;           ///< absolute path of the shared library; empty: built in
  std::string description = {};  ///< the YAML file of a foreign model
  std::vector<std::string> of_example = {};  ///< names of the parameters that have the values of the model's example
  std::vector<std::string> warnings = {};    ///< sentences on the source that it was compiled from
  std::vector<ModelFile> files = {};         ///< for the folder of a process of its own
  std::string source = {};                   ///< absolute path of the Fortran source of the library
  std::optional<adapters::ForeignModel> foreign = {};  ///< what it is taken for, of a foreign one
};

/// The model ended the worker in which it was to be created.
class ModelEnded : public InputError {
 public:
  ModelEnded(const Location& where, const std::string& key, const std::string& what_happened)
      : InputError(where, key, what_happened), sentence(what_happened) {}
  std::string sentence;
};

/// Which parameters that are not given take the value at which the model's author shows it (assay.example/1).
enum class Example { none, where_required, all };

/// Finds and creates it. Throws InputError: not found, not loadable, a parameter that it does not take or lacks, no
/// density, refused by the model itself; for a vortex, a material that is anisotropic in Cartesian axes; a direction
/// that it does not have. Of these, ModelEnded.
ResolvedMaterial resolve_material(const Scene& scene);

/// Throws InputError at the material where it is one of plane stress (NTENS = 3): `why` it does not serve.
void refuse_plane_stress(const ResolvedMaterial& material, const std::string& key, const std::string& why);

/// The same without a motion to suit.
ResolvedMaterial resolve_material(const MaterialChoice& choice, Example example = Example::none);

}  // namespace assay::drivers
