// SPDX-License-Identifier: BSD-3-Clause
// Sheets kept on disk: what costs a second to make is read in a millisecond.
#pragma once

#include <optional>
#include <string>

#include "drivers/scene/scene.hpp"
#include "harness/sheet/sheet.hpp"

namespace assay::drivers {

/// One file a sheet under ${ASSAY_CACHE_HOME:-${XDG_CACHE_HOME:-~/.cache}/assay}/sheets, named by the hash of
/// everything that the sheet is made from: the bytes of this program and of the material's library, parameters, path,
/// tolerance. A cache: what cannot be read, or is damaged, is made again; what cannot be written is not kept. A model
/// that is not the program's own may read files or its environment: it is asked at a few places, and where it answers
/// otherwise than the sheet, that is made again, too.
class SheetCache {
 public:
  /// Of material and path, which outlive it.
  SheetCache(const Scene& scene, const Material& material, const Path& path, double end);

  /// Throws MaterialFailure where the model fails at one of those places.
  std::optional<Sheet> load() const;
  void store(const Sheet& sheet) const;

  /// Empty where sheets are not kept: no home, or the material's library cannot be told.
  const std::string& file() const { return file_; }

 private:
  std::optional<Sheet> stored() const;
  bool is_still_right(const Sheet& sheet) const;

  const Material& material_;
  const Path& path_;
  double asked_until_;  ///< [s]
  bool is_our_own_ = false;
  std::string key_, file_;
};

}  // namespace assay::drivers
