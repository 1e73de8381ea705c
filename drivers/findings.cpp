// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/findings.hpp"

#include <algorithm>

#include "drivers/input_error.hpp"
#include "drivers/output/number_format.hpp"
#include "drivers/scene/sha256.hpp"
#include "drivers/scene/yaml_reader.hpp"

namespace assay::drivers {

void record_sheet(const Response& response, double seconds, Result& result) {
  const Sheet* sheet = response.sheet();
  if (!sheet) return;
  result.sheet = SheetFigures{sheet->points(), sheet->error_tau(), sheet->error_dtau(), seconds};
  result.material_calls += sheet->material_calls();
}

std::string material_provenance(const Material& material, const std::string& library) {
  const char* version = material.table().version;
  const std::string who = material.name() + (version ? " " + one_line(version, 80) : "");
  if (library.empty()) return who + ", built in";
  constexpr std::size_t largest_library = std::size_t{4} << 30;
  return who + ", " + library + ", sha256 " + sha256_hex(read_bytes(library, largest_library));
}

void record_failure(const MaterialFailure& failure, Result& result) {
  result.outcome = "material_failed";
  result.reason = std::string(failure.what()) + ": on the baseline path at xi = " + rounded_text(failure.xi, 6) +
                  ", t = " + rounded_text(failure.t, 6) + " s";
  result.t = failure.t;
}

int exit_status(const Result& result) {
  const bool all_hold = std::all_of(result.expect.begin(), result.expect.end(), [](const auto& e) { return e.holds; });
  const bool outcome_expected =
      std::any_of(result.expect.begin(), result.expect.end(), [](const auto& e) { return e.key == "outcome"; });
  return all_hold && (outcome_expected || result.outcome == "completed") ? 0 : 1;
}

}  // namespace assay::drivers
