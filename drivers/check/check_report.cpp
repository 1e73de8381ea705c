// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_report.hpp"

#include <nlohmann/json.hpp>

#include "drivers/output/junit.hpp"
#include "drivers/result/json_fields.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;
using check::TestResult;
using check::Verdict;

template <class T, class U>
concept Is = std::is_same_v<std::remove_const_t<T>, U>;

// What JSON says, once for its writer and its reader.

void describe(Is<Dependence> auto& self, auto&& archive) { ASSAY_MEMBERS(on, how); }

void describe(Is<check::Diagnosis> auto& self, auto&& archive) { ASSAY_MEMBERS(cause, sentence); }

void describe(Is<TestResult> auto& self, auto&& archive) {
  ASSAY_MEMBERS(id, verdict, wall_s, measure, threshold, order);
  archive.or_null("cause", self.cause);
  ASSAY_MEMBERS(sentence);
}

void describe(Is<CheckedMaterial> auto& self, auto&& archive) {
  archive("material", self.name);
  archive.or_null("library", self.library);
  archive.if_any("description", self.description);
  archive.or_null("model", self.model);
  archive("parameters", self.parameters);
  archive.if_any("parameters_of_example", self.of_example);
  archive.derived("verdict", overall(self));
  archive.or_null("error", self.error);
  archive.or_null("unwritten", self.unwritten);
  ASSAY_MEMBERS(printed, wall_s);
  ASSAY_MEMBERS(warnings);
  archive("strain", self.report.strain);
  archive("pressure", self.report.pressure);
  archive("step", self.report.effort.step);
  archive("not_tested", self.report.not_tested);
  archive.if_any("depends_on", self.depends_on);
  archive("diagnosis", self.report.diagnosis);
  archive("tests", self.report.tests);
}

using Values = std::vector<std::pair<std::string, double>>;

struct Writer {
  Json out = Json::object();

  template <class T>
  static Json of(const T& value) {
    Writer inner;
    if constexpr (requires { describe(value, inner); }) {
      describe(value, inner);
    } else if constexpr (std::is_same_v<T, Verdict>) {
      return verdict_name(value);
    } else if constexpr (std::is_same_v<T, Values>) {
      for (const auto& [name, number] : value) inner(name, number);
    } else if constexpr (is_list_field<T>) {
      inner.out = Json::array();
      for (const auto& each : value) inner.out.push_back(of(each));
    } else {
      return JsonFields<Json>::of(value);
    }
    return inner.out;
  }

  void operator()(const std::string& key, const auto& value) { out[key] = of(value); }
  void derived(const char* key, const auto& value) { out[key] = value; }
  void or_null(const char* key, const std::string& text) { out[key] = json_text(text); }
  void if_any(const char* key, const auto& value) {
    if (!value.empty()) out[key] = of(value);
  }
};

/// Throws Json::exception if a member is missing or has the wrong type. A null leaves the value as it was.
struct Reader {
  const Json& in;

  template <class T>
  static void take(const Json& from, T& value) {
    if constexpr (requires(Reader inner) { describe(value, inner); }) {
      describe(value, Reader{from});
    } else if constexpr (std::is_same_v<T, Verdict>) {
      for (const Verdict each : {Verdict::pass, Verdict::fail, Verdict::not_applicable}) {
        if (from == verdict_name(each)) value = each;
      }
    } else if constexpr (std::is_same_v<T, Values>) {
      for (const auto& [name, number] : from.items()) take(number, value.emplace_back(name, NAN).second);
    } else if constexpr (is_list_field<T>) {
      for (const Json& each : from) take(each, value.emplace_back());
    } else if (!from.is_null()) {
      value = from.get<std::conditional_t<Optional<T>::value, double, T>>();
    }
  }

  void operator()(const char* key, auto& value) const { take(in.at(key), value); }
  void or_null(const char* key, std::string& text) const { take(in.at(key), text); }
  void derived(const char*, const auto&) const {}
  void if_any(const char* key, auto& value) const {
    if (in.contains(key)) take(in.at(key), value);
  }
};

Json json_of(const CheckedMaterial& checked) {
  Json out = Writer::of(checked);
  for (Json& test : out["tests"]) {
    const auto replay = checked.replays.find(test["id"]);
    test["replay"] = replay == checked.replays.end() ? Json() : Json(replay->second);
  }
  return out;
}

}  // namespace

std::string check_json(const CheckedMaterial& checked) { return json_document(json_of(checked)); }

std::string check_json(const std::vector<CheckedMaterial>& all) {
  Json out;
  const auto any = [&](const char* verdict) {
    return std::ranges::any_of(all, [&](const auto& checked) { return overall(checked) == verdict; });
  };
  out["verdict"] = any("fail") ? "fail" : any("error") ? "error" : "pass";
  out["materials"] = Json::array();
  for (const CheckedMaterial& checked : all) out["materials"].push_back(json_of(checked));
  return json_document(out);
}

std::optional<CheckedMaterial> checked_of_json(const std::string& text) {
  const Json found = Json::parse(text, nullptr, false);
  if (found.is_discarded()) return std::nullopt;
  try {
    CheckedMaterial checked;
    Reader::take(found, checked);
    for (TestResult& test : checked.report.tests) {  // JSON has no infinity
      if (!test.measure && test.threshold && test.verdict == Verdict::fail) test.measure = INFINITY;
    }
    for (const Json& test : found.at("tests")) {
      if (!test.at("replay").is_null()) checked.replays[test.at("id")] = test.at("replay");
    }
    return checked;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

void fail_test(check::Report& report, TestResult& test, const std::string& cause, const std::string& sentence) {
  test.verdict = Verdict::fail;
  test.cause = cause;
  test.sentence = sentence;
  report.diagnosis.push_back({cause, sentence});
}

void add_test(check::Report& report, TestResult test) {
  if (test.verdict == Verdict::fail) report.diagnosis.push_back({test.cause, test.sentence});
  report.tests.push_back(std::move(test));
}

void say_instead(check::Report& report, TestResult& test, const std::string& sentence) {
  for (check::Diagnosis& diagnosis : report.diagnosis) {
    if (diagnosis.sentence == test.sentence) diagnosis = {test.cause, sentence};
  }
  test.sentence = sentence;
}

void say_also(check::Report& report, const std::string& sentence, const std::string& more) {
  std::vector<std::string*> found;  // `sentence` may be one of them
  for (check::Diagnosis& each : report.diagnosis) {
    if (each.sentence == sentence) found.push_back(&each.sentence);
  }
  for (TestResult& test : report.tests) {
    if (test.sentence == sentence) found.push_back(&test.sentence);
  }
  for (std::string* each : found) *each += more;
}

void remark(TestResult& test, const std::string& words) {
  test.sentence += std::string("; ") + check::remark_words + words;
}

namespace {

/// The same wherever the library lies.
std::string class_of(const CheckedMaterial& checked) {
  return "assay.check." + (is_material_name(checked.name) || checked.model.empty() ? checked.name : checked.model);
}

JunitCase test_case(const CheckedMaterial& checked, const TestResult& test, const std::string& classname) {
  using enum JunitCase::Kind;
  if (test.verdict == Verdict::pass) return {classname, test.id, test.wall_s};
  if (test.verdict == Verdict::not_applicable) return {classname, test.id, test.wall_s, skipped, test.sentence};
  const auto replay = checked.replays.find(test.id);
  const std::string figures =
      "measured " + measured_text(test.measure) + ", at most " + measured_text(test.threshold) +
      (replay == checked.replays.end() ? "" : "; again: assay check --replay " + replay->second);
  return {classname, test.id, test.wall_s, failure, test.cause + ": " + test.sentence, test.cause, figures};
}

JunitSuite suite(const CheckedMaterial& checked, const std::string& given) {
  const std::string classname = given.empty() ? class_of(checked) : "assay.check." + given;
  JunitSuite out{"assay check " + (given.empty() ? checked.name : given), "assay.check"};
  out.seconds = checked.wall_s;
  for (const auto& [name, value] : checked.parameters) out.properties.emplace_back(name, number_text(value));
  if (!checked.of_example.empty()) out.properties.emplace_back("parameters of the example", joined(checked.of_example));
  for (const std::string& what : checked.report.not_tested) out.properties.emplace_back("not tested", what);
  for (const std::string& warning : checked.warnings) out.properties.emplace_back("warning", warning);
  for (const Dependence& each : checked.depends_on) out.properties.emplace_back("depends on " + each.on, each.how);
  for (const TestResult& test : checked.report.tests) {
    out.cases.push_back(test_case(checked, test, classname));
    if (const std::string remark = remark_of(test); !remark.empty())
      out.properties.emplace_back("remark of " + test.id, remark);
  }
  if (!checked.error.empty())
    out.cases.push_back({classname, "loading", 0, JunitCase::Kind::error, checked.error, "not checked"});
  for (const std::string& warning : checked.warnings) out.said += "warning: " + warning + "\n";
  for (const check::Diagnosis& d : checked.report.diagnosis) out.said += d.cause + ": " + d.sentence + "\n";
  return out;
}

}  // namespace

std::string check_junit(const std::vector<CheckedMaterial>& all, const std::string& name) {
  return junit_text(mapped(all, [&](const CheckedMaterial& checked) { return suite(checked, name); }));
}

}  // namespace assay::drivers
