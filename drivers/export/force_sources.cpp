// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/force_sources.hpp"

#include <algorithm>
#include <map>
#include <numbers>

#include "drivers/export/export.hpp"
#include "drivers/result/result.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

/// The pieces as five lists, as all sources hold them.
struct ForceLists {
  std::vector<double> radii, times, numbers;
  std::vector<std::size_t> first_term{0}, first_number{0};

  explicit ForceLists(const ForcePieces& pieces) : radii(pieces.radii), times(pieces.times) {
    for (const auto& piece : pieces.pieces)
      for (const ForceSeries& series : piece) {
        for (const ForceTerm& term : series)
          for (const auto* powers : {&term.P, &term.Q}) {
            numbers.insert(numbers.end(), powers->begin(), powers->end());
            first_number.push_back(numbers.size());
          }
        first_term.push_back(first_term.back() + series.size());
      }
  }
};

/// A number of Fortran is a double only with its exponent's letter.
std::string fortran_number(const std::string& text) {
  const std::size_t e = text.find('e');
  return e == text.npos ? text + "d0" : text.substr(0, e) + "d" + text.substr(e + 1);
}

std::vector<std::string> number_words(const std::vector<double>& values, bool fortran) {
  return mapped(values, [=](double value) {
    std::string text = coefficient_text(value);
    return fortran ? fortran_number(text) : text;
  });
}

std::vector<std::string> number_words(const std::vector<std::size_t>& values, bool) {
  return mapped(values, [](std::size_t value) { return std::to_string(value); });
}

/// Some words of a list in each line.
std::string list_lines(const std::vector<std::string>& words, std::size_t a_line, const std::string& between) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (k > 0) text += k % a_line == 0 ? between : " ";
    text += words[k] + (k + 1 < words.size() ? "," : "");
  }
  return text;
}

/// DATA statements of so many lines each as all compilers take.
std::string data_statements(const std::string& name, const std::vector<std::string>& words, bool fixed) {
  constexpr std::size_t a_line = 2, a_statement = 15 * a_line;  // fixed form has 72 columns
  std::string text;
  for (std::size_t first = 0; first < words.size(); first += a_statement) {
    const std::size_t end = std::min(words.size(), first + a_statement);
    const std::string range = std::to_string(first + 1) + ", " + std::to_string(end);
    const std::vector<std::string> some(words.begin() + static_cast<std::ptrdiff_t>(first),
                                        words.begin() + static_cast<std::ptrdiff_t>(end));
    if (fixed)
      text +=
          "      DATA (" + name + "(L), L = " + range + ") /\n     1 " + list_lines(some, a_line, "\n     1 ") + "/\n";
    else
      text +=
          "  data (" + name + "(l), l = " + range + ") / &\n      " + list_lines(some, a_line, " &\n      ") + " /\n";
  }
  return text;
}

std::string data_of(const ForceLists& lists, bool fixed) {
  const auto statements = [&](const char* free_name, const char* fixed_name, const auto& values) {
    return data_statements(fixed ? fixed_name : free_name, number_words(values, true), fixed);
  };
  return statements("radii", "RADII", lists.radii) + statements("times", "TIMES", lists.times) +
         statements("first_term", "FTERM", lists.first_term) + statements("first_number", "FNUMB", lists.first_number) +
         statements("number", "NUMBER", lists.numbers);
}

using ForceWords = std::map<std::string, std::string>;

/// What may stand in a comment of any of the languages: nothing that ends it, continues it or is no ASCII.
std::string comment_words(const std::string& title) {
  constexpr std::size_t longest = 60;  // of the 72 columns of fixed form
  std::string words = title.substr(0, longest);
  for (char& c : words) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       std::string_view(" ,.;:()=+-").find(c) != std::string_view::npos;
    if (!plain) c = ' ';
  }
  return words;
}

ForceWords words_of(const ForcePieces& pieces, const ForceLists& lists, const std::string& title) {
  const auto size = [](const auto& list) { return std::to_string(list.size()); };
  const auto listed = [](const auto& values) { return list_lines(number_words(values, false), 4, "\n    "); };
  ForceWords words{{"TITLE", comment_words(title)},
                   {"VERSION", build_information().version},
                   {"END", coefficient_text(pieces.times.back())},
                   {"ERROR", rounded_text(pieces.error, 2)},
                   {"LARGEST", rounded_text(pieces.largest, 6)},
                   {"RINGS", std::to_string(pieces.rings())},
                   {"SLABS", std::to_string(pieces.slabs())}};
  words["N_RADII"] = size(lists.radii), words["RADII"] = listed(lists.radii);
  words["N_TIMES"] = size(lists.times), words["TIMES"] = listed(lists.times);
  words["N_NUMBERS"] = size(lists.numbers), words["NUMBERS"] = listed(lists.numbers);
  words["N_FIRST_TERM"] = size(lists.first_term), words["FIRST_TERM"] = listed(lists.first_term);
  words["N_FIRST_NUMBER"] = size(lists.first_number), words["FIRST_NUMBER"] = listed(lists.first_number);
  return words;
}

/// Lines that turn (c, d), the direction of the reference position, by alpha = g(t) h(R).
std::string turning_lines(ForceLanguage language, const Vortex& vortex) {
  const bool fortran = language == ForceLanguage::fortran, python = language == ForceLanguage::python;
  AmplitudeWords words;
  words.sine = python ? "np.sin" : "sin";
  words.number = [=](double value) { return fortran ? fortran_number(number_text(value)) : number_text(value); };
  words.least = [=](const std::string& t, const std::string& T) {
    return (language == ForceLanguage::c ? "fmin(" : "min(") + t + ", " + T + ")";
  };
  const double middle = 0.5 * (vortex.inner + vortex.outer), half = 0.5 * (vortex.outer - vortex.inner);
  const std::string R = python ? "r" : "R", now = fortran ? "now" : "t", power = std::to_string(vortex.profile_power);
  const std::string s = "((" + R + " - " + words.number(middle) + ") / " + words.number(half) + ")";
  const std::string h =
      language == ForceLanguage::c ? "pow(1 - " + s + " * " + s + ", " + power + ")" : "(1 - " + s + "**2)**" + power;
  const std::string g = amplitude_expression(vortex.amplitude, now, words);
  if (python)
    return "        alpha = " + g + " * " + h +
           "  # by which the point has turned\n"
           "        c, d = c * np.cos(alpha) - d * np.sin(alpha), d * np.cos(alpha) + c * np.sin(alpha)\n";
  if (fortran)
    return "    ! the angle by which the point has turned\n    s = " + g + " &\n        * " + h +
           "\n    u = c * cos(s) - d * sin(s)\n    d = d * cos(s) + c * sin(s)\n    c = u\n";
  return "  /* the angle by which the point has turned */\n  s = " + g + " * " + h +
         ";\n  u = c * cos(s) - d * sin(s);\n  d = d * cos(s) + c * sin(s);\n  c = u;\n";
}

}  // namespace

std::string amplitude_expression(const Amplitude& g, const std::string& t, const AmplitudeWords& words) {
  using std::numbers::pi;
  const std::string wave = words.sine + "(" + words.number(pi / g.period) + " * " + t + ")";
  const std::string peak = words.number(g.peak);
  switch (g.type) {
    case Amplitude::Type::sine:
      return peak + " * " + wave;
    case Amplitude::Type::one_minus_cosine:
      return peak + " * " + wave + " * " + wave;  // (1 - cos)/2 = sin^2
    case Amplitude::Type::ramp:
      break;
  }
  return words.number(g.peak / g.period) + " * " + words.least(t, words.number(g.period));
}

std::string force_file(ForceLanguage language) {
  constexpr const char* endings[] = {".c", ".f90", ".py"};
  return std::string("vortex_force") + endings[static_cast<std::size_t>(language)];
}

std::string force_source(ForceLanguage language, const ForcePieces& pieces, ForceCoordinates at,
                         const std::string& title) {
  const ForceLists lists(pieces);
  ForceWords words = words_of(pieces, lists, title);
  const bool turned = at == ForceCoordinates::reference;
  words["COORDINATES"] = turned ? "reference" : "current";
  words["TURN"] = turned ? turning_lines(language, pieces.vortex) : "";
  words["DATA"] = data_of(lists, false);
  return filled_template("force", force_file(language), words);
}

std::string abaqus_force(AbaqusRoutine routine, const ForcePieces& pieces, double density, const std::string& title) {
  const ForceLists lists(pieces);
  ForceWords words = words_of(pieces, lists, title);
  std::string data = data_of(lists, true);
  data.pop_back();
  words["DATA"] = data;
  words["DENSITY"] = fortran_number(coefficient_text(density));
  return filled_template("force", routine == AbaqusRoutine::vdload ? "vortex_vdload.f" : "vortex_dload.f", words) +
         filled_template("force", "vortex_force.f", words);
}

}  // namespace assay::drivers
