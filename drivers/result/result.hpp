// SPDX-License-Identifier: BSD-3-Clause
// What a verb found: the content of result.json and errors.csv. Figures not reached are absent (null in the file). What
// `fields` of a struct names (drivers/result/fields.hpp) is in result.json, and from there in expectations, studies,
// the JSON Schema and docs/results.md.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/result/result_sections.hpp"
#include "drivers/text/units.hpp"

namespace assay {
struct FailedStep;
}

namespace assay::drivers {

struct ExpectationOutcome {
  std::string key;
  std::string expected;
  std::string found;
  bool holds = false;

  static void fields(auto& self, auto& archive) {
    archive("key", self.key, "", "key that something is expected of");
    archive("expected", self.expected, "", "operator and value, as below 0.07");
    archive("found", self.found, "", "value as text, as 0.0633 or null");
    archive("holds", self.holds, "", "whether the expectation holds");
  }
};

struct Provenance {
  std::string version, git, compiler, flags;
  std::string material;
  std::vector<std::string> libraries;
  std::string scene_sha256;

  static void fields(auto& self, auto& archive) {
    archive("version", self.version, "", "version of assay");
    archive("git", self.git, "", "what the program was built from, as git describes it");
    archive("compiler", self.compiler, "", "compiler that the program was built with");
    archive("flags", self.flags, "", "flags of that compiler");
    archive("libraries", self.libraries, "", "libraries that are in the program, with their versions");
    archive("material", self.material, "",
            "name and version of the material; its shared library with the SHA-256 of the file, or built in");
    archive("scene_sha256", self.scene_sha256, "", "SHA-256 of the bytes of the scene file, before --set");
  }
};

/// What this binary was built from, with what, and how: version, `git describe` of the sources ("unknown" outside a
/// checkout), compiler, its flags, versions of the libraries; `scene_sha256` is left empty. Never fails.
Provenance build_information();

/// Version and sources of this binary, "0.2.0 v0.2.0-12-g0123456": what works together is alike in it.
std::string build_text();

struct Result {
  std::string title;
  Units units;          ///< of the scene's author, for what people read; the figures are in SI
  std::string subject;  ///< what was run, one line: material, method, grid, amplitude
  std::string outcome = "completed";
  std::string reason;
  std::string replay;
  std::string last_good;
  std::string advice;                             ///< what an unstable run could try; empty: nothing better is known
  std::shared_ptr<const FailedStep> failed_step;  ///< that step
  std::vector<std::string> warnings;
  bool disturbed = false;  ///< the process that ran the material
  std::string printed;     ///< by a material that runs apart
  Figure t, dt;
  std::optional<std::int64_t> steps, particles, moving_particles;
  bool uses_exact_solution = false;
  ErrorFigures error;
  /// One after the other, of a clock on the wall: until the first step, the steps, and what comes behind them. Together
  /// they are the life of the verb until its verdict; `tabulate` makes its response in place of steps.
  double setup_s = 0, wall_s = 0, finish_s = 0;
  double observed_s = 0;  ///< of wall_s: sampling of the error and snapshots
  double cpu_s = 0;
  Figure step_cpu_s;
  std::int64_t peak_rss_bytes = 0;
  std::int64_t particle_steps = 0, material_calls = 0;
  std::int64_t hand_overs = 0, wake_ups = 0;
  Figure particle_steps_per_s;
  std::vector<PassFigures> passes;
  std::optional<SheetFigures> sheet;
  std::optional<ScreenFigures> screen;
  std::optional<RimFigures> rim;  ///< absent without kinks
  ReferenceFigures reference;
  std::optional<GrowthFigures> growth;     ///< absent where the error does not grow so, or no tractions act
  std::optional<TractionTable> tractions;  ///< only where the scene asks for it, and then in result.json
  DriftFigures drift;
  HealthFigures health;
  std::vector<ExpectationOutcome> expect;
  Provenance provenance;
  std::vector<ErrorSample> history;  ///< errors.csv

  std::optional<std::int64_t> held_particles() const {
    return particles && moving_particles ? std::optional(*particles - *moving_particles) : std::nullopt;
  }
  /// Read and written in the particle columns by all steps.
  double bytes() const {
    double sum = 0;
    for (const PassFigures& pass : passes) sum += pass.bytes_per_particle;
    return sum * static_cast<double>(particle_steps);
  }

  static void fields(auto& self, auto& archive) {
    name_end(self, archive);
    archive("error", self.error);
    name_costs(self, archive);
    archive("passes", self.passes);
    archive.section("sheet", self.sheet);
    archive.section("screen", self.screen);
    archive("reference", self.reference);
    archive.section("rim", self.rim);
    archive.section("growth", self.growth);
    if (self.tractions) archive("tractions", self.tractions->runs);
    archive("drift", self.drift);
    archive("health", self.health);
    archive(
        "last_good", or_null(self.last_good), "",
        "last_good.vtu if the run did not reach its end: its particles at most 64 steps, or 1/200 of the run, before");
    archive("replay", or_null(self.replay), "", "replay.yaml or replay_scene.yaml, which shows again what went wrong");
    archive("expect", self.expect);
    archive("provenance", self.provenance);
  }

 private:
  static void name_end(auto& self, auto& archive) {
    archive("outcome", self.outcome, "",
            "completed; unstable; material_failed; refused, if the motion is not a stable solution for the model");
    archive("reason", or_null(self.reason), "",
            "one sentence if the run did not complete: cause, particle, reference position, time");
    archive("warnings", self.warnings, "", "list of problems that did not stop the run");
    archive("t", self.t, "s", "time reached; for an unstable run, the time of the step that failed");
    archive("dt", self.dt, "s", "time step");
    archive("steps", self.steps, "1", "number of steps");
    archive("particles", self.particles, "1", "number of particles of the body, held particles included");
    archive("particles_held", self.held_particles(), "1",
            "number of particles that the motion holds fixed; these are not stepped");
    archive("uses_exact_solution", self.uses_exact_solution, "",
            "whether the method knows more than the body force and the initial state");
  }

  static void name_costs(auto& self, auto& archive) {
    archive("setup_s", self.setup_s, "s",
            "wall clock time before the first step: reading, creating particles, screen, sheet");
    archive("wall_s", self.wall_s, "s", "wall time of the step loop",
            "with sampling and snapshots; for tabulate, of the response and its references");
    archive("finish_s", self.finish_s, "s",
            "wall clock time after the steps: pictures, tables, the runs of output.tractions");
    archive("cpu_s", self.cpu_s, "s", "processor time of the run", "up to the verdict");
    archive("step_cpu_s", self.step_cpu_s, "s", "processor time of the steps",
            "without set-up, sampling, snapshots and pictures");
    archive("peak_rss_bytes", self.peak_rss_bytes, "B", "peak memory", "of the process before pictures are drawn");
    archive.section("work", [&](auto& work) {
      work("particle_steps", self.particle_steps, "1", "particle-steps", "stepped particles times steps");
      work("material_calls", self.material_calls, "1", "calls of the material",
           "each of which updates a point, those for the sheet included");
      work("hand_overs", self.hand_overs, "1", "hand-overs to the workers of a foreign material",
           "0 for other materials");
      work("wake_ups", self.wake_ups, "1", "times that one side of a hand-over had to be woken",
           "0 for other materials; differs from run to run");
      work("bytes", self.bytes(), "B", "bytes read and written in particle columns", "by all passes of all steps");
    });
    archive("particle_steps_per_s", self.particle_steps_per_s, "1/s",
            "particle-steps over the time of the passes, without sampling and snapshots");
  }
};

}  // namespace assay::drivers
