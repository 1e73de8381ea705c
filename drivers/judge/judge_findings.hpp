// SPDX-License-Identifier: BSD-3-Clause
// What judge finds: of each run its errors, its particles and its labels; of all together the order. The content of
// judge.json.
#pragma once

#include <string>
#include <vector>

#include "drivers/judge/labels.hpp"
#include "drivers/mistakes/identification.hpp"
#include "drivers/result/fields.hpp"
#include "drivers/result/result.hpp"
#include "drivers/scene/scene.hpp"

namespace assay::drivers {

struct LabelFigures {
  std::string cause, sentence;
  Figure before, after;

  static void fields(auto& self, auto& archive) {
    archive("cause", self.cause, "", "short name of what is wrong with the data");
    archive("sentence", self.sentence, "", "what was found, as a sentence");
    archive("before", self.before, "",
            "error of the field with the data as they are, in its unit; null where none was compared");
    archive("after", self.after, "", "error of the field without that mistake");
  }
};

struct MistakeFigures {
  std::string mistake, sentence;
  bool named = false;
  Figure size, explained, factor;

  static void fields(auto& self, auto& archive) {
    archive("mistake", self.mistake, "", "short name of the mistake");
    archive("sentence", self.sentence, "", "the mistake of the size that fits best, as a sentence");
    archive("named", self.named, "", "whether it is one of those that the answer names");
    archive("size", self.size, "", "its size: a factor [1] or a time [s]");
    archive("explained", self.explained, "1", "share of the square of the error that it explains");
    archive("factor", self.factor, "1", "by which its effect is to be multiplied to fit best");
  }
};

/// What a code does wrong, by the errors of its positions over the body and over time.
struct CodeFindings {
  std::string answer, sentence;
  Figure error, discretisation;
  std::vector<double> waves;
  std::vector<MistakeFigures> mistakes;
  /// Roots of mean squares over the body: of the error, and of what the best mistake leaves of it [m].
  std::vector<double> t = {}, of_error = {}, of_rest = {};
  bool is_wrong() const { return answer == "named" || answer == "alike"; }

  static void fields(auto& self, auto& archive) {
    archive("answer", or_null(self.answer), "",
            "named: one mistake explains the error; alike: several do; doubtful: one does, and the grid may; method: "
            "nothing is left but the grid's own error; unknown: none explains it; null: not looked for");
    archive("sentence", self.sentence, "", "what was found");
    archive("error", self.error, "m", "error that is to be explained", "without what finer grids would take away");
    archive("discretisation", self.discretisation, "m", "error of the finest grid", "by the grids or by its size");
    archive(
        "waves", self.waves, "1",
        "shares of the square of the error that go around the ring 0, 1, ... 8 times: 0 of forces, times and models, "
        "1 of a shifted origin, 4 and 8 of a square lattice");
    archive("mistakes", self.mistakes);
  }
};

struct JudgedGrid {
  std::string name;
  Figure h, spacing;
  std::int64_t particles = 0, frames = 0, measured = 0;
  std::int64_t lost = 0, doubled = 0, unknown = 0, not_numbers = 0;
  Figure lost_from;
  std::vector<std::string> left_out;
  std::string read, times, pairing;
  Figure rounding;
  ErrorFigures error;
  Figure worst, worst_t, worst_id;
  std::vector<double> worst_X;
  std::vector<LabelFigures> labels;
  Figure seconds, cores;
  std::string machine;
  std::vector<ErrorSample> history = {};  ///< errors.csv
  std::string picture = {};               ///< error.png: particles at the time of the largest error; in the plane
  std::string picture_caption = {};
  std::optional<BinnedErrors> bins = {};  ///< by which mistakes of the code are told
  bool by_nearest = false;                ///< neither ids nor reference positions tell the particles
  bool is_beyond_sight = false;           ///< its errors are as large as such a pairing can show
  Figure start;                           ///< error of v at t = 0 over the scene's v; absent where no v is written then
  Figure relative_stress;                 ///< its largest error over time, over the largest stress of the scene [1]

  static void fields(auto& self, auto& archive) {
    archive("name", self.name, "", "file or folder of the run");
    archive("h", self.h, "m", "spacing of the grid", "by --h, or the distance between particles");
    archive("particles", self.particles, "1", "number of particles");
    archive("frames", self.frames, "1", "number of times");
    archive("measured", self.measured, "1", "particles that the exact motion moves, in the frame where most are");
    archive("lost", self.lost, "1", "particles that are missing in the frame where most are");
    archive("doubled", self.doubled, "1", "particles that are there twice, likewise");
    archive("unknown", self.unknown, "1", "particles that were not there at first, likewise");
    archive("not_numbers", self.not_numbers, "1", "particles whose position is no number, likewise");
    archive("spacing", self.spacing, "m", "distance between particles");
    archive("lost_from", self.lost_from, "s",
            "time of the first frame in which particles are lost, doubled or no numbers");
    archive("left_out", self.left_out, "", "other files in the folder, which were not read");
    archive("read", self.read, "", "which names were taken for which quantities");
    archive("times", self.times, "", "where the times come from");
    archive("pairing", self.pairing, "", "how particles were told from one another");
    archive("rounding", self.rounding, "m", "half of the last digit of the positions: smaller errors are not seen");
    archive("error", self.error);
    archive("worst", self.worst, "m", "largest error of a position");
    archive("worst_t", self.worst_t, "s", "its time");
    archive("worst_id", self.worst_id, "", "id of that particle, or its number from 0 without ids");
    archive("worst_X", self.worst_X, "m", "reference position of that particle");
    archive("labels", self.labels);
    archive("seconds", self.seconds, "s", "time that the run took, as the map says");
    archive("cores", self.cores, "1", "cores that it took");
    archive("machine", or_null(self.machine), "", "machine that it ran on");
  }
};

struct JudgeFindings {
  std::string title, scene, code;
  std::vector<JudgedGrid> runs;  ///< the coarsest first
  Figure order, order_lower, order_upper, last_order;
  std::string range;
  std::vector<ExpectationOutcome> expect;
  CodeFindings code_findings;
  std::vector<std::string> warnings;
  bool good = true;
  std::string verdict;
  Provenance provenance;

  static void fields(auto& self, auto& archive) {
    archive("title", self.title, "", "title of the scene");
    archive("scene", self.scene, "", "file of the scene");
    archive("code", or_null(self.code), "", "name of the code, as the map says");
    archive("good", self.good, "", "whether nothing is wrong: the exit status is 0");
    archive("verdict", self.verdict, "", "one sentence");
    archive("order", self.order, "1", "observed order of the largest L2 error of u", "fitted over all grids");
    archive("order_lower", self.order_lower, "1", "lower end of its 95 % interval");
    archive("order_upper", self.order_upper, "1", "upper end of its 95 % interval");
    archive("last_order", self.last_order, "1", "order between the two finest grids");
    archive("range", or_null(self.range), "", "whether the asymptotic range is reached, as a sentence");
    archive("expect", self.expect);
    archive.section("mistakes_of_code", [&](auto& inner) { CodeFindings::fields(self.code_findings, inner); });
    archive("warnings", self.warnings, "", "sentences on what is doubtful");
    archive("runs", self.runs);
    archive("provenance", self.provenance);
  }
};

/// Pairs and judges one run, which is without these labels by now. half_period, end: T/2 and the last time [s].
/// bins: for the errors of the positions, where mistakes of the code are looked for.
JudgedGrid judged_grid(JudgedRun run, const std::vector<Label>& labels, double half_period, double end,
                       ExactParticles& exact, std::optional<BinnedErrors> bins, std::vector<std::string>& warnings);

/// Looks for mistakes of the code behind the errors of the runs. Throws MaterialFailure, Interrupted.
void find_mistakes(JudgeFindings& findings, const Scene& scene, const std::shared_ptr<const Material>& material,
                   bool quiet);

/// Whether the velocities at t = 0 are not those of the scene.
bool starts_otherwise(const JudgeFindings& findings);

/// Orders over the runs, what becomes of the expectations of orders and of the finest run's errors, and the verdict.
void conclude(JudgeFindings& findings, const std::vector<Expectation>& expected);

std::string judge_json(const JudgeFindings& findings);
std::string judge_text(const JudgeFindings& findings, const std::string& folder);
std::string judge_html(const JudgeFindings& findings, const std::string& resolved_scene, double period);
std::string judge_junit(const JudgeFindings& findings, const std::string& name, double seconds);

}  // namespace assay::drivers
