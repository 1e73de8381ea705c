// SPDX-License-Identifier: BSD-3-Clause
// Sheets kept on disk: what costs a second to make is read in a millisecond.
#pragma once

#include <optional>
#include <string>

#include "drivers/scene/scene.hpp"
#include "harness/sheet.hpp"

namespace assay::drivers {

/// One file a sheet under ${ASSAY_CACHE_HOME:-${XDG_CACHE_HOME:-~/.cache}/assay}/sheets, named by the hash of
/// everything that the sheet is made from: the bytes of this program and of the material's library, parameters, path,
/// tolerance. A cache: what cannot be read, or is damaged, is made again; what cannot be written is not kept. Never
/// fails.
class SheetCache {
 public:
  SheetCache(const Scene& scene, const Material& material, const Path& path, double end);

  std::optional<Sheet> load() const;
  void store(const Sheet& sheet) const;

  /// Empty where sheets are not kept: no home, or the material's library cannot be told.
  const std::string& file() const { return file_; }

 private:
  std::string file_;
};

}  // namespace assay::drivers
