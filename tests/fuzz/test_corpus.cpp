// SPDX-License-Identifier: BSD-3-Clause
// Replays the fuzzer's seeds and finds, their prefixes, and single damaged bytes. The entry aborts on a fault.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "drivers/scene/scene_reader.hpp"
#include "tests/fuzz/composition.hpp"
#include "tests/fuzz/mutants.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace assay::test_corpus {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> seeds() {
  std::vector<std::string> texts;
  for (const char* folder : {"configs", "tests/fuzz/corpus", "tests/fuzz/scenes"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(tree_folder()) / folder)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream in(entry.path(), std::ios::binary);
      std::ostringstream text;
      text << in.rdbuf();
      texts.push_back(text.str());
    }
  }
  return texts;
}

/// A copy of its own, so that reading past the end meets the sanitizer's guard.
void feed(const std::string& text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  EXPECT_EQ(LLVMFuzzerTestOneInput(bytes.data(), bytes.size()), 0);
}

/// Of each text; the fuzzer itself goes on from there.
const std::size_t places = sanitized() ? 30 : 200;

/// Of all prefixes those whose number is even or odd.
void feed_prefixes(const std::string& text, std::size_t rest) {
  const std::size_t step = 1 + 2 * text.size() / places;
  for (std::size_t n = rest * step; n < text.size(); n += 2 * step) feed(text.substr(0, n));
}

TEST(FuzzCorpus, SeedsAndTheirPrefixes) {
  const auto texts = seeds();
  ASSERT_GE(texts.size(), 5u);
  for (const std::string& text : texts) {
    feed_prefixes(text, 0);
    feed(text);
  }
}

TEST(LongFuzzCorpus, MorePrefixes) {
  for (const std::string& text : seeds()) feed_prefixes(text, 1);
}

/// The bounds of the composition leave these scenes in: the prefixes above and the bytes below reach it.
TEST(FuzzCorpus, ScenesOfFewParticlesAreComposed) {
  int composed = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(tree_folder()) / "tests/fuzz/scenes")) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW(assay::fuzz::compose_scene(assay::drivers::read_scene(entry.path().string()))) << entry.path();
    ++composed;
  }
  EXPECT_GE(composed, 12);
}

/// A negative control: more particles than the composition takes are refused before any is made.
TEST(FuzzCorpus, ScenesOfManyParticlesAreRefused) {
  const std::string scene = tree_folder() + "/tests/fuzz/scenes/vortex_cpdi.yaml";
  for (const char* spacing : {"grid.spacing=0.003", "grid.spacing=1e-200"}) {
    const auto large = assay::drivers::read_scene(scene, {spacing});
    EXPECT_THROW(assay::fuzz::compose_scene(large), assay::drivers::InputError) << spacing;
  }
}

constexpr std::size_t shares = 20;

/// Of all damages those whose number leaves this rest when it is divided by the number of shares.
void feed_damaged(std::size_t rest) {
  const std::string damages("\0[{}]:\"'\n&*!-#9\xff", 16);
  std::size_t turn = 0;
  for (std::string text : seeds()) {
    for (std::size_t at = 0; at < text.size(); at += 1 + text.size() / places, ++turn) {
      if (turn % shares != rest) continue;
      const char kept = text[at];
      text[at] = damages[turn % damages.size()];
      feed(text);
      text[at] = kept;
    }
  }
}

TEST(FuzzCorpus, DamagedBytes) { feed_damaged(0); }

TEST(LongFuzzCorpus, MoreDamagedBytes) {
  for (std::size_t rest = 1; rest < shares; ++rest) feed_damaged(rest);
}

/// As those that run through the program itself, others of them.
TEST(FuzzCorpus, MutantsAreComposedOrRefused) {
  const assay::fuzz::Mutants mutants = assay::fuzz::mutants_of_the_tree();
  for (int number = 10000; number < 10400; ++number) feed(mutants.at(number).text);
}

TEST(FuzzCorpus, AbusiveNesting) {
  for (const char* opening : {"[", "{a: ", "- ", "? ", "!!a ", "&a "}) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += opening;
    feed(text);
  }
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 9; ++k) bomb += (k ? ", " : "") + last;
    bomb += "]\n";
  }
  feed(bomb);
}

}  // namespace
}  // namespace assay::test_corpus
