// SPDX-License-Identifier: BSD-3-Clause
// replay.yaml: the one step of one point at which a material failed, or the test that it failed, to be taken again
// alone.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "drivers/material/material_choice.hpp"
#include "drivers/system/input_error.hpp"
#include "harness/check/battery.hpp"
#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"

namespace assay::drivers {

struct Replay {
  std::string material;  ///< as find_material takes it: a name, or `library:name` with the library's absolute path
  std::map<std::string, double> parameters;  ///< all of them
  std::string library_sha256;                ///< of the shared library; empty: built in
  std::optional<FailedStep> step;            ///< none of a test in which the process ended
  std::string reason;                        ///< one sentence
  std::vector<std::string> varying = {};     ///< fields of a foreign model that a path has changed
  std::string test = {};                     ///< id of the test of `check` that failed; empty: none
  check::Effort effort = {};                 ///< of that test
  bool rate_dependent = false;               ///< was taken for it, where nobody had declared anything
  Location where = {};                       ///< of `material` in a file that was read
};

/// SHA-256 of a file in hexadecimal digits, once for each state of the file. Throws InputError, SystemError.
std::string hash_of_library(const std::string& file);

/// Of that material. Throws InputError where its library is gone.
Replay replay_of(const ResolvedMaterial& material, const std::optional<FailedStep>& step, const std::string& reason);

/// Numbers at full precision; state0 by the names of the material's state variables. Throws InputError where the
/// material is gone.
std::string replay_yaml(const Replay& replay, Isolation isolation = Isolation::automatic);

/// `material` takes the place of the file's, unless it is empty. Where $ASSAY_MATERIAL_PATH is not set, that of the
/// file is from then on. Throws InputError: no such file, not a replay, a material that is not found or has another
/// state.
Replay read_replay(const std::string& file, Isolation isolation = Isolation::automatic,
                   const std::string& material = {});

/// The material of a replay. Throws InputError where it is not found.
ResolvedMaterial resolved_of(const Replay& replay, Isolation isolation = Isolation::automatic);

}  // namespace assay::drivers
