// SPDX-License-Identifier: BSD-3-Clause
// The card of a standard set: what each code has reached on each problem. The content of card.json.
#pragma once

#include <string>
#include <vector>

#include "drivers/judge/judge_findings.hpp"
#include "drivers/standard/standard_set.hpp"

namespace assay::drivers {

struct CardGrid {
  Figure h, l2, relative, core_s;

  static void fields(auto& self, auto& archive) {
    archive("h", self.h, "m", "spacing of the grid");
    archive("l2", self.l2, "m", "largest L2 error of u over time");
    archive("relative", self.relative, "1", "the same, of the largest displacement");
    archive("core_s", self.core_s, "s", "seconds of the run times its cores");
  }
};

struct CardRow {
  std::string id, title;
  bool good = false;
  std::string found;  ///< one sentence
  Figure order, order_lower, order_upper, last_order;
  std::vector<CardGrid> grids;      ///< the coarsest first
  std::vector<std::string> causes;  ///< of labels

  bool was_run() const { return !grids.empty(); }
  static void fields(auto& self, auto& archive) {
    archive("id", self.id, "", "id of the problem");
    archive("title", self.title, "", "title of its scene");
    archive("good", self.good, "", "whether all that the set asks for is met");
    archive("found", self.found, "", "one sentence");
    archive("order", self.order, "1", "observed order over all grids");
    archive("order_lower", self.order_lower, "1", "lower end of its 95 % interval");
    archive("order_upper", self.order_upper, "1", "upper end of its 95 % interval");
    archive("last_order", self.last_order, "1", "order between the two finest grids");
    archive("grids", self.grids);
    archive("causes", self.causes, "", "short names of what is wrong");
  }
};

struct CardCode {
  std::string name, machine;
  std::vector<CardRow> rows;

  std::size_t run() const;
  std::size_t passed() const;
  static void fields(auto& self, auto& archive) {
    archive("name", self.name, "", "name of the code");
    archive("machine", or_null(self.machine), "", "machine that it ran on");
    archive("rows", self.rows);
  }
};

struct StandardCard {
  std::string title;
  std::int64_t edition = 1;
  std::vector<CardCode> codes;
  Provenance provenance;

  static void fields(auto& self, auto& archive) {
    archive("title", self.title, "", "title of the set");
    archive("edition", self.edition, "1", "edition of the set");
    archive("codes", self.codes);
    archive("provenance", self.provenance);
  }
};

/// The row of a problem that was judged.
CardRow row_of(const StandardProblem& problem, const JudgeFindings& findings);

/// Of a problem without a judgement: why.
CardRow row_without(const StandardProblem& problem, const std::string& why);

/// The findings on a folder of results: FOLDER/ID/h_0.05, a folder or file for each grid. A map is
/// FOLDER/judge.map.yaml or FOLDER/ID/judge.map.yaml. The files of each judgement go to OUT/ID. Throws InputError where
/// a file is damaged, or none is there at all.
CardCode judged_code(const StandardSet& set, const std::string& folder, const std::string& out, bool quiet);

std::string card_json(const StandardCard& card);
std::string card_text(const StandardCard& card);
std::string card_markdown(const StandardCard& card);
std::string card_html(const StandardCard& card);

}  // namespace assay::drivers
