// SPDX-License-Identifier: BSD-3-Clause
// The kinds of YAML files that there are, told by their keys.
#pragma once

#include "drivers/format/yaml_reader.hpp"

namespace assay::drivers {

enum class FileKind { scene, study, description, replay };

/// Throws InputError "this is a scene, not a study: use `assay run`" for a file of another kind than is wanted; what
/// has a key that tells the wanted kind is taken for it. The program's own results in JSON are named, too.
void refuse_other_kind(const Tree& root, FileKind wanted);

}  // namespace assay::drivers
