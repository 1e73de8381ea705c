// SPDX-License-Identifier: BSD-3-Clause
// That equal calls give equal results, to the last bit: again, in another order, from elsewhere, by another instance.
#include <alloca.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "harness/check/tests.hpp"
#include "harness/material/stack_below.hpp"

namespace assay::check {

namespace {

constexpr double most_of_repeats = 1e-12;  ///< what is below is judged at the end of the battery

/// The first histories of the process again, small after large.
void compare_histories(const Specimen& specimen, const std::vector<History>& first, Difference& difference) {
  constexpr const char* what = "of a history that was the first of the process";
  const auto amplitudes = amplitudes_of_first(specimen.options.effort);
  for (int again = 0; again < 2; ++again) {
    for (std::size_t k = 0; k < first.size(); ++k) {
      const History found = history(*specimen.material, amplitudes[k]);
      if (found.size() != first[k].size()) difference.note(1, what);
      difference.note(Comparison(specimen.material->table(), first[k]), found, what);
    }
  }
  const History& elsewhere = specimen.options.elsewhere;
  if (first.empty() || elsewhere.size() != first.back().size()) return;
  difference.note(Comparison(specimen.material->table(), first.back()), elsewhere,
                  "of a history with which another process has begun");
}

/// One after the other, against each after a step of another volume.
void compare_shears(const Specimen& specimen, const Steps& others, Difference& difference) {
  const Steps steps = sheared_steps(specimen, 9);
  std::vector<Result> first;
  for (std::size_t p = 0; p < steps.n; ++p) {
    alone(specimen, others, p % others.n);
    first.push_back(alone(specimen, steps, p));
  }
  const Comparison with(specimen.material->table(), first);
  for (std::size_t p = steps.n; p-- > 0;) {
    difference.note(with.difference(p, alone(specimen, steps, p)),
                    "of a shear, taken again after others of the volume,");
  }
}

/// None where a model does not take them.
std::optional<Material> of_other_parameters(const Specimen& specimen) {
  const Material& material = *specimen.material;
  const assay_material* table = specimen.options.table_of_others;
  try {
    return Material(table ? table : &material.table(), other_parameters(material), material.pace());
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

/// An instance of other parameters does not change this one's answers, nor this one those of the other.
void compare_instances(const Specimen& specimen, const Steps& steps, const Comparison& with, Difference& difference) {
  const std::optional<Material> altered = of_other_parameters(specimen);
  if (!altered) return;
  alone(*altered, steps, 0);
  for (std::size_t p = 0; p < steps.n; p += 3) {
    difference.note(with.difference(p, alone(specimen, steps, p)), "taken beside an instance of other parameters");
  }
  const History& elsewhere = specimen.options.others_elsewhere;
  if (elsewhere.empty()) return;
  const History here = history(*altered, amplitudes_of_first(specimen.options.effort).back());
  difference.note(Comparison(specimen.material->table(), here), elsewhere,
                  "of an instance of other parameters, the first of a process,");
}

/// What other numbers do to a step in memory that nobody has set.
struct MemoryEffect {
  double differs = 0;  ///< at most, of its value
  bool fails = false;  ///< it is refused, or no number
  bool matters() const { return fails || differs > most_of_repeats; }
  double measure() const { return differs > most_of_repeats ? differs : INFINITY; }
  std::string words() const {
    return differs > most_of_repeats ? "differs by " + rounded(differs) + " of its value" : "is refused, or no number,";
  }
};

/// A step alone, over a byte in the memory that `Over` fills.
template <class Over>
Result alone_over(unsigned char byte, const Material& material, const Steps& steps, std::size_t p) {
  const Over memory(byte);
  return alone(material, steps, p);
}

/// Steps that differ over the same numbers, too, tell nothing of these.
template <class Over>
void compare_over(const Material& material, const Steps& steps, MemoryEffect& effect) {
  for (std::size_t p = 0; p < steps.n; p += 3) {
    const std::vector<Result> zeros{alone_over<Over>(0, material, steps, p)};
    const Comparison with(material.table(), zeros);
    const auto over = [&](unsigned char byte) {
      return with.difference(0, alone_over<Over>(byte, material, steps, p));
    };
    const double again = over(0), once_more = over(0);
    if (again > 0 || once_more > 0) continue;
    for (const unsigned char byte : unset_bytes) {
      const double difference = over(byte);
      if (!(difference > most_of_repeats) || over(0) > 0) continue;
      if (std::isfinite(difference)) effect.differs = std::max(effect.differs, difference);
      effect.fails |= !std::isfinite(difference);
    }
  }
}

/// In the middle of a history, and from rest: a model may ask for the first step of a point.
template <class Over>
MemoryEffect effect_of(const Specimen& specimen, const Steps& steps) {
  MemoryEffect effect;
  compare_over<Over>(specimen, steps, effect);
  compare_over<Over>(specimen, steps_from_rest(specimen, 4, specimen.amplitude), effect);
  return effect;
}

/// Steps in other orders, after larger loads, of another instance.
void compare_steps(const Specimen& specimen, const Steps& steps, Difference& difference) {
  const auto amplitudes = amplitudes_of_first(specimen.options.effort);
  history(specimen, amplitudes.front());
  const std::vector<Result> first = one_by_one(specimen, steps);
  const Comparison with(specimen.material->table(), first);
  const auto take = [&](const Material& instance, std::size_t p, const char* how) {
    difference.note(with.difference(p, alone(instance, steps, p)), how);
  };
  for (std::size_t p = steps.n; p-- > 0;) take(specimen, p, "taken again, backwards,");
  for (std::size_t p = 0; p < steps.n; ++p) {
    for (int again = 0; again < 2; ++again) take(specimen, p, "taken twice");
  }
  history(specimen, amplitudes.back());
  difference.note(with, one_by_one(specimen, steps), "taken after a larger load");
  compare_instances(specimen, steps, with, difference);
  const Material other = specimen.material->clone();
  for (std::size_t p = 0; p < steps.n; p += 3) take(other, p, "of another instance");
}

}  // namespace

std::map<std::string, double> other_parameters(const Material& material) {
  std::map<std::string, double> all;
  for (std::uint32_t k = 0; k < material.table().parameter_count; ++k) {
    const assay_parameter& parameter = material.table().parameters[k];
    const double larger = 1.01 * material.parameters()[k];
    const bool within = larger >= parameter.lower && larger <= parameter.upper;
    all[parameter.name] = within ? larger : material.parameters()[k];
  }
  return all;
}

TestResult repeated_calls(const Specimen& specimen, const std::vector<History>& first, Difference& found) {
  Difference difference;
  MemoryEffect of_stack, of_heap;
  compare_histories(specimen, first, difference);
  try {
    const Steps steps = steps_along(specimen, specimen.options.effort.quick ? 12 : 40);
    compare_steps(specimen, steps, difference);
    of_stack = effect_of<OverStack>(specimen, steps);
    of_heap = effect_of<OverHeap>(specimen, steps);
    compare_shears(specimen, steps, difference);
  } catch (const MaterialFailure&) {  // where it is loaded while it turns: the tests of rotation tell
  }
  found = difference;
  const auto by_memory = [&](const MemoryEffect& effect, const char* why) {
    return failed(causes::hidden_state, std::max(effect.measure(), difference.worst), most_of_repeats,
                  "the same step " + effect.words() + why);
  };
  if (of_stack.matters())
    return by_memory(of_stack, " if the stack holds other numbers: a local variable is read before it is set");
  if (of_heap.matters())
    return by_memory(of_heap, " if allocated memory holds other numbers: an array is read before it is set");
  return judged(difference.worst, most_of_repeats,
                "a step has the same result when it is repeated, in another order or by another instance",
                causes::hidden_state,
                "the same step " + difference.how + " differs by " + rounded(difference.worst) +
                    " of its value: the model keeps data outside the state");
}

namespace {

/// A call so many bytes deeper in the stack: multiples of 64 leave the alignment of what is there.
[[gnu::noinline]] auto deeper(std::size_t bytes, const auto& call) {
  void* room = alloca(bytes);
  __asm__ volatile("" : : "r"(room) : "memory");
  return call();
}

/// A call from arrays elsewhere: others of their sizes take the places that they had.
auto from_elsewhere(std::size_t count, std::size_t state_size, const auto& call) {
  constexpr std::size_t more = cache_line / sizeof(double);
  std::vector<std::vector<double>> others;
  for (std::size_t k = 0; k < count; ++k) {
    for (const std::size_t size : {std::size_t{9}, state_size, 9 + more, state_size + more}) others.emplace_back(size);
  }
  return call();
}

class Repeats {
 public:
  explicit Repeats(const Specimen& specimen)
      : specimen_(specimen),
        steps_(steps_along(specimen, specimen.options.effort.quick ? 6 : 20)),
        first_(one_by_one(*specimen.material, steps_)) {}

  Difference run() {
    for (std::size_t p = 0; p < steps_.n; p += 2) take_again(p);
    take_batch_again();
    take_of_other_instances();
    return difference_;
  }

 private:
  const Material& material() const { return *specimen_.material; }

  void note(std::size_t p, const Result& found, const char* how) {
    difference_.note(Comparison(material().table(), first_).difference(p, found), how);
  }

  void take_again(std::size_t p) {
    const auto call = [&] { return alone(material(), steps_, p); };
    note(p, call(), "taken again");
    for (const unsigned char byte : unset_bytes) {
      const OverHeap heap(byte);
      const OverStack stack(byte);
      note(p, call(), "with other words left in memory by earlier calls");
    }
    for (const std::size_t lines : {1, 2, 3, 77}) {
      note(p, deeper(lines * cache_line, call), "taken deeper in the stack");
      note(p, from_elsewhere(lines, steps_.size, call), "with arrays at other addresses");
    }
  }

  void take_batch_again() {
    const Steps batch = many_of(steps_, 37);
    const std::vector<Result> once = together(material(), batch), again = together(material(), batch);
    difference_.note(Comparison(material().table(), once), again, "in the same batch again");
  }

  /// Blocks of other sizes lie between them, so that their addresses are no multiples of one number.
  void take_of_other_instances() {
    constexpr std::size_t instances = 12;
    std::deque<Material> others;
    std::vector<std::vector<double>> between;
    for (std::size_t k = 0; k < instances; ++k) {
      between.emplace_back(3 + 2 * k);
      others.push_back(material().clone());
      for (std::size_t p = 1; p < steps_.n; p += 2) note(p, alone(others.back(), steps_, p), "of another instance");
    }
  }

  const Specimen& specimen_;
  Steps steps_;
  std::vector<Result> first_;
  Difference difference_;
};

/// Whatever time it is: of the first histories of the process the last.
void compare_first_with_last(const Specimen& specimen, const std::vector<History>& first, Difference& difference) {
  if (first.empty()) return;
  const History again = history(*specimen.material, amplitudes_of_first(specimen.options.effort).back());
  difference.note(Comparison(specimen.material->table(), first.back()), again, "at the end of the battery");
}

}  // namespace

TestResult last_digits(const Specimen& specimen, const std::vector<History>& first, const Difference& repeated) {
  Difference difference = repeated;
  try {
    const Difference found = Repeats(specimen).run();
    difference.note(found.worst, found.how);
    compare_first_with_last(specimen, first, difference);
  } catch (const MaterialFailure&) {  // where it is loaded while it turns: the tests of rotation tell
  }
  const std::string by = std::isfinite(difference.worst) ? "differs by " + rounded(difference.worst) + " of itself"
                                                         : "is refused, or no number";
  return judged(difference.worst, 0, "a step that is repeated has the same result to the last bit",
                causes::not_reproducible,
                "the same step " + difference.how + " " + by + ": equal calls do not give equal bits");
}

}  // namespace assay::check
