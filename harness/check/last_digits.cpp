// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/last_digits.hpp"

#include <alloca.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <deque>
#include <memory>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

/// Doubles of such bytes are 0, 4.8e-4, -8.5e3 and no number.
constexpr std::array<unsigned char, 4> litter{0x00, 0x3f, 0xc0, 0xff};

/// What it finds in memory that it allocates.
void litter_heap(unsigned char byte) {
  constexpr std::array<std::size_t, 10> sizes{24, 48, 72, 144, 288, 328, 648, 1024, 2048, 6400};  // [bytes]
  std::array<std::unique_ptr<unsigned char[]>, 2 * sizes.size()> blocks;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const std::size_t size = sizes[k / 2];
    blocks[k] = std::make_unique_for_overwrite<unsigned char[]>(size);
    std::memset(blocks[k].get(), byte, size);
    __asm__ volatile("" : : "r"(blocks[k].get()) : "memory");
  }
}

/// A call so many bytes deeper in the stack: multiples of 64 leave the alignment of what is there.
template <class Call>
[[gnu::noinline]] auto deeper(std::size_t bytes, const Call& call) {
  void* room = alloca(bytes);
  __asm__ volatile("" : : "r"(room) : "memory");
  return call();
}

/// A call from arrays elsewhere: others of their sizes take the places that they had.
template <class Call>
auto from_elsewhere(std::size_t count, std::size_t state_size, const Call& call) {
  constexpr std::size_t more = Placed::line / sizeof(double);
  std::vector<std::vector<double>> others;
  for (std::size_t k = 0; k < count; ++k) {
    for (const std::size_t size : {std::size_t{9}, state_size, 9 + more, state_size + more}) others.emplace_back(size);
  }
  return call();
}

class Repeats {
 public:
  explicit Repeats(const Specimen& specimen)
      : specimen_(specimen), steps_(steps_along(specimen, specimen.options.effort.quick ? 6 : 20)) {
    for (std::size_t p = 0; p < steps_.n; ++p) first_.push_back(alone(material(), steps_, p));
  }

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
    for (const unsigned char byte : litter) {
      litter_heap(byte);
      litter_stack(byte);
      note(p, call(), "with other words left in memory by earlier calls");
    }
    for (const std::size_t lines : {1, 2, 3, 77}) {
      note(p, deeper(lines * Placed::line, call), "taken deeper in the stack");
      note(p, from_elsewhere(lines, steps_.size, call), "with arrays at other addresses");
    }
  }

  void take_batch_again() {
    const Steps batch = many_of(steps_, 37);
    const std::vector<Result> once = together(material(), batch), again = together(material(), batch);
    const Comparison with(material().table(), once);
    for (std::size_t p = 0; p < batch.n; ++p) difference_.note(with.difference(p, again[p]), "in the same batch again");
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
  const Comparison with(specimen.material->table(), first.back());
  for (std::size_t p = 0; p < std::min(again.size(), first.back().size()); ++p) {
    difference.note(with.difference(p, again[p]), "at the end of the battery");
  }
}

}  // namespace

[[gnu::noinline]] void litter_stack(unsigned char byte) {
  constexpr std::size_t reach = 48 << 10;  // [bytes], beyond the arrays of `Material::update`
  std::array<unsigned char, reach> room;
  std::memset(room.data(), byte, room.size());
  __asm__ volatile("" : : "r"(room.data()) : "memory");
}

TestResult last_digits(const Specimen& specimen, const std::vector<History>& first, const Difference& repeated) {
  Difference difference = repeated;
  try {
    const Difference found = Repeats(specimen).run();
    difference.note(found.worst, found.how);
    compare_first_with_last(specimen, first, difference);
  } catch (const MaterialFailure&) {  // where it is loaded while it turns: the tests of rotation tell
  }
  TestResult result{.id = "calls.bits", .measure = difference.worst, .threshold = 0};
  result.sentence = "a step that is repeated has the same result to the last bit";
  if (difference.worst == 0) return result;
  result.verdict = Verdict::fail;
  result.cause = causes::not_reproducible;
  const std::string by = std::isfinite(difference.worst) ? "differs by " + rounded(difference.worst) + " of itself"
                                                         : "is refused, or no number";
  result.sentence = "the same step " + difference.how + " " + by + ": equal calls do not give equal bits";
  return result;
}

}  // namespace assay::check
