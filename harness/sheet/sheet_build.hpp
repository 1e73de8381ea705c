// SPDX-License-Identifier: BSD-3-Clause
// How a sheet is refined, and how its error is found out.
#pragma once

#include <optional>

#include "harness/sheet/sheet.hpp"

namespace assay {

/// These workers, which report between `count` histories: behind those that are done, and before those that are
/// planned.
Workers reporting(Workers workers, const SheetOptions& options, const SheetProgress& before, double count);

/// A curve refined to the tolerance.
struct BuiltCurve {
  Curve curve;
  SheetError error;
  std::int64_t calls = 0;
};
BuiltCurve build_curve(const Material& material, const Path& path, const SheetOptions& options);

/// By what changes of regime are told, if they are looked for.
using Watch = std::optional<Telling>;

/// Band tables refined to the tolerance.
struct BuiltBands {
  std::vector<BandSeries> tables;
  Watch watch;  ///< how their breaks were found
  SheetError error;
  std::int64_t calls = 0;
};
BuiltBands build_bands(const Material& material, const Path& path, const SheetOptions& options);

/// Against histories off the nodes, integrated in increments even where the tables come from the rate form: tau
/// directly, d tau / d xi by eighth-order central differences between histories of one band in one stretch.
SheetError error_of(const std::vector<BandSeries>& tables, const Material& material, const Path& path,
                    const SheetOptions& options, Watch watch, std::int64_t& calls);

}  // namespace assay
