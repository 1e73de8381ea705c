// SPDX-License-Identifier: BSD-3-Clause
// Studies for the tests of their reader and of their plan.
#pragma once

#include <string>

#include "drivers/study/plan/study_reader.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers {

/// A scene that is read and assembled in no time: 64 particles, no sheet.
inline const char* const small_scene =
    "motion: {type: vortex}\n"
    "material: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n"
    "body: {domain: square, lower: [-1.5, -1.5], upper: [1.5, 1.5]}\n"
    "grid: {spacing: 0.75}\n"
    "method: {basis: cpdi, transfer: flip}\n"
    "force: {response: closed_form}\n"
    "expect: {outcome: completed}\n";

/// A folder with a scene, s.yaml, and studies of it; what is read is named study.yaml.
class StudyFolder {
 public:
  StudyFolder() { scratch_.write("s.yaml", small_scene); }

  std::string file() const { return scratch_ / "study.yaml"; }

  /// `text` after the line `scene: s.yaml`, which is the first.
  Study read(const std::string& text) const { return study_from_text("scene: s.yaml\n" + text, file()); }

  /// The refusal of that, without the folder: "study.yaml:2:1: key: what"; "accepted".
  std::string refusal(const std::string& text) const {
    return shortened_line(refusal_of([&] { read(text); }));
  }

  /// The name of the folder taken away wherever it stands.
  std::string shortened_line(std::string line) const {
    const std::string folder = scratch_ / "";
    for (std::size_t at; (at = line.find(folder)) != line.npos;) line.erase(at, folder.size());
    return line;
  }

  const ScratchFolder& scratch() const { return scratch_; }

 private:
  ScratchFolder scratch_;
};

}  // namespace assay::drivers
