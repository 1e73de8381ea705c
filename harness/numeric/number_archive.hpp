// SPDX-License-Identifier: BSD-3-Clause
// Values as a list of numbers, and back: what processes hand each other. A struct says once what it is made of,
//
//   template <class Archive> void fields(Archive& archive, Struct& s) { archive(s.one, s.other); }
//
// and both directions follow.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "harness/numeric/tensor.hpp"

namespace assay {

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Both directions of it. Archive::exchange(numbers, count) keeps these numbers, or fills them in; require(count) says
/// that so many must follow. Every bit of what is written comes back: an integer goes as the bits of a double, never as
/// its value.
template <class Archive>
class NumberArchive {
 public:
  template <class... Parts>
  void operator()(Parts&... parts) {
    (pass(parts), ...);
  }

 private:
  Archive& archive() { return static_cast<Archive&>(*this); }

  void pass(double& value) { archive().exchange(&value, 1); }
  template <Plain T>
  void pass(T& value) {
    double bits = std::bit_cast<double>(static_cast<std::uint64_t>(value));
    pass(bits);
    value = static_cast<T>(std::bit_cast<std::uint64_t>(bits));
  }
  void pass(Tensor& tensor) { archive().exchange(tensor.data(), 9); }
  void pass(Vector3& vector) { archive().exchange(vector.data(), 3); }
  void pass(std::vector<double>& list) {
    list.resize(passed_size(list.size()));
    archive().exchange(list.data(), list.size());
  }
  template <class T>
  void pass(std::vector<T>& list) {
    list.resize(passed_size(list.size()));  // every item takes one number at least
    for (T& item : list) pass(item);
  }
  template <class T>
  void pass(std::optional<T>& part) {
    bool is_there = part.has_value();
    pass(is_there);
    if (is_there) pass(part ? *part : part.emplace());
  }
  void pass(std::string& text) {
    constexpr std::size_t letters = sizeof(double);  // of a number
    text.resize(passed_size(text.size(), letters));
    std::vector<double> numbers((text.size() + letters - 1) / letters);
    std::copy(text.begin(), text.end(), reinterpret_cast<char*>(numbers.data()));
    archive().exchange(numbers.data(), numbers.size());
    std::copy_n(reinterpret_cast<const char*>(numbers.data()), text.size(), text.begin());
  }
  template <class T>
  requires(!Plain<T>) void pass(T& parts) { fields(archive(), parts); }

  std::size_t passed_size(std::uint64_t size, std::size_t to_a_number = 1) {
    pass(size);
    archive().require(size / to_a_number);
    return size;
  }
};

class NumberWriter : public NumberArchive<NumberWriter> {
 public:
  std::vector<double> numbers;

  void exchange(const double* first, std::size_t count) { numbers.insert(numbers.end(), first, first + count); }
  void require(std::size_t) const {}
};

/// Throws std::runtime_error where the list is too short: it may come from a process that is not trusted.
class NumberReader : public NumberArchive<NumberReader> {
 public:
  explicit NumberReader(std::span<const double> numbers) : left_(numbers) {}

  void exchange(double* first, std::size_t count) {
    require(count);
    std::copy_n(left_.begin(), count, first);
    left_ = left_.subspan(count);
  }
  void require(std::size_t count) const {
    if (count > left_.size()) throw std::runtime_error("a list of numbers is cut");
  }

 private:
  std::span<const double> left_;
};

}  // namespace assay
