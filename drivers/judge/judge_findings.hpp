// SPDX-License-Identifier: BSD-3-Clause
// What judge finds: of each run its errors, its particles and its labels; of all together the order. The content of
// judge.json.
#pragma once

#include <string>
#include <vector>

#include "drivers/judge/labels.hpp"
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

struct JudgedGrid {
  std::string name;
  Figure h, spacing;
  std::int64_t particles = 0, frames = 0;
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

  static void fields(auto& self, auto& archive) {
    archive("name", self.name, "", "file or folder of the run");
    archive("h", self.h, "m", "spacing of the grid", "by --h, or the distance between particles");
    archive("particles", self.particles, "1", "number of particles");
    archive("frames", self.frames, "1", "number of times");
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
    archive("warnings", self.warnings, "", "sentences on what is doubtful");
    archive("runs", self.runs);
    archive("provenance", self.provenance);
  }
};

/// Pairs and judges one run, whose positions are without these labels. half_period, end: T/2 and the last time [s].
JudgedGrid judged_grid(JudgedRun run, std::vector<Label> labels, double half_period, double end, ExactParticles& exact,
                       std::vector<std::string>& warnings);

/// Orders over the runs, what becomes of the expectations of orders and of the finest run's errors, and the verdict.
void conclude(JudgeFindings& findings, const std::vector<Expectation>& expected);

std::string judge_json(const JudgeFindings& findings);
std::string judge_text(const JudgeFindings& findings, const std::string& folder);
std::string judge_html(const JudgeFindings& findings, const std::string& resolved_scene, double period);
std::string judge_junit(const JudgeFindings& findings, const std::string& name, double seconds);

}  // namespace assay::drivers
