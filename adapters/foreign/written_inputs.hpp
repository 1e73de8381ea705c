// SPDX-License-Identifier: BSD-3-Clause
// Arrays that foreign code is handed: one block of memory with fences between them, and a watch over those among them
// that are inputs. An input that the model writes to is harmless here, where it is made anew, and another host's own
// data.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace assay::adapters {

class GuardedArrays {
 public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  /// Doubles: more than a tangent's row, or a few state variables too many; and where one looks for more.
  static constexpr std::size_t usual_fence = 32, widest_fence = 512;
  explicit GuardedArrays(std::size_t fence = usual_fence);

  /// Handle of a new array of n doubles, zero at first; one of none begins where its fence does. `name` as the
  /// interface has it.
  std::size_t add(std::string name, std::size_t n);

  double* operator[](std::size_t handle) { return memory_.data() + arrays_[handle].begin; }
  const double* operator[](std::size_t handle) const { return memory_.data() + arrays_[handle].begin; }
  std::size_t size(std::size_t handle) const { return arrays_[handle].size; }

  void fill(std::size_t handle, double value);

  std::size_t count() const { return arrays_.size(); }
  /// The memory of this and all later arrays, fences and all.
  std::span<const double> from(std::size_t handle) const { return std::span(memory_).subspan(arrays_[handle].begin); }

  /// What was written where it must not be: "writes past STATEV"; nothing where all fences stand. Repairs them. Those
  /// from array `known_whole` on, where one is given, are known to stand.
  std::optional<std::string> broken_fence(std::size_t known_whole = none);

  /// All fences one after the other, for a look at what is read there: words in their place until they are taken back.
  std::size_t fence_words() const { return fence_ * (arrays_.size() + 1); }
  void lend(std::span<const double> words);
  /// Which of the words that were lent have been written to.
  std::vector<std::size_t> take_back(std::span<const double> words);

  /// An element that no array has: of the array that it lies behind, or shortly before.
  struct Beyond {
    std::string array;
    std::size_t size;      ///< of the array
    std::ptrdiff_t index;  ///< counted from 1: above `size`, or below 1

    friend void fields(auto& archive, Beyond& b) { archive(b.array, b.size, b.index); }
  };
  Beyond place_of(std::size_t word) const;

 private:
  struct Array {
    std::string name;
    std::size_t begin, size;
  };
  void add_fence();
  bool whole(std::size_t at) const;
  bool all_whole(std::size_t before) const;
  std::size_t begin_of_fence(std::size_t k) const { return k == 0 ? 0 : arrays_[k - 1].begin + arrays_[k - 1].size; }

  std::size_t fence_;
  std::vector<double> memory_;
  std::vector<Array> arrays_;
};

/// Or-ed, with what else a process is watched for (Habit): the lowest byte and the upper half are left to that.
using Habits = std::uint64_t;
using WrittenInput = std::uint32_t;
inline constexpr WrittenInput written_stran = 1u << 8, written_dstran = 1u << 9, written_time = 1u << 10,
                              written_dtime = 1u << 11, written_temp = 1u << 12, written_predef = 1u << 13,
                              written_props = 1u << 14, written_coords = 1u << 15, written_drot = 1u << 16,
                              written_celent = 1u << 17, written_dfgrd0 = 1u << 18, written_dfgrd1 = 1u << 19,
                              written_integers = 1u << 20, written_strain_inc = 1u << 21, written_stretch = 1u << 22,
                              written_defgrad = 1u << 23, written_stress_old = 1u << 24, written_state_old = 1u << 25,
                              written_temperatures = 1u << 26, written_energies = 1u << 27, written_others = 1u << 28,
                              written_beginning = 1u << 29, written_gradients = 1u << 30, written_properties = 1u << 31;
inline constexpr Habits any_written_input = 0xffffff00;

/// "STRAN, DTIME"; empty where none is written.
std::string written_input_names(std::uint32_t written);

/// Of all models of this process so far.
std::uint32_t written_inputs();

/// Compares inputs after a call with what was handed over. They are the last arrays of a block, so that one comparison
/// of memory tells that they and their fences are whole.
class InputWatch {
 public:
  enum Change { once, every_call };  ///< when the host writes to it

  /// Inputs begin with the array that is added next.
  void begin(const GuardedArrays& arrays);
  /// The handle of a new array of n doubles that is an input, all of it.
  std::size_t add_array(GuardedArrays& arrays, const std::string& words, std::size_t n, WrittenInput name,
                        Change change = every_call);
  /// `count` doubles of an array from `first` on; all where count is 0.
  void add(WrittenInput name, Change change, std::size_t handle, std::size_t first = 0, std::size_t count = 0);
  /// Integers that are handed over by reference; they live as long as this.
  void add_integers(WrittenInput name, int* integers, std::size_t count);

  /// Those that the host writes to once have been written to again.
  void forget() { image_.clear(); }

  /// Before the call.
  void keep(const GuardedArrays& arrays);
  /// After it: what was written past an array, as GuardedArrays tells it. Inputs that are not as they were are put
  /// right, and noted where `noted`.
  std::optional<std::string> broken_fence(GuardedArrays& arrays, bool noted = true);

 private:
  struct Part {
    WrittenInput name;
    Change change;
    std::size_t handle, first, count;
  };
  bool intact(const GuardedArrays& arrays) const;
  std::uint32_t restore(GuardedArrays& arrays);

  std::size_t begin_ = 0;
  std::vector<Part> parts_;
  std::vector<double> image_;  ///< of the block from its first input on, fences and all
  WrittenInput integers_name_ = written_integers;
  int* integers_ = nullptr;
  std::vector<int> kept_integers_;
};

}  // namespace assay::adapters
