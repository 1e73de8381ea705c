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
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "harness/numeric/tensor.hpp"

namespace assay {

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Every bit of what it is given comes back: an integer goes as the bits of a double, never as its value.
class NumberWriter {
 public:
  template <class... Parts>
  void operator()(Parts&... parts) {
    (put(parts), ...);
  }
  std::vector<double> numbers;

 private:
  void put(double& value) { numbers.push_back(value); }
  template <Plain T>
  void put(T& value) {
    numbers.push_back(std::bit_cast<double>(static_cast<std::uint64_t>(value)));
  }
  void put(Tensor& tensor) { numbers.insert(numbers.end(), tensor.data(), tensor.data() + tensor.size()); }
  void put(Vector3& vector) { numbers.insert(numbers.end(), vector.data(), vector.data() + vector.size()); }
  void put(std::vector<double>& list) {
    put_size(list.size());
    numbers.insert(numbers.end(), list.begin(), list.end());
  }
  template <class T>
  void put(std::vector<T>& list) {
    put_size(list.size());
    for (T& item : list) put(item);
  }
  void put(std::string& text) {
    put_size(text.size());
    for (std::size_t at = 0; at < text.size(); at += sizeof(double)) {  // eight letters a number
      double eight = 0;
      std::memcpy(&eight, text.data() + at, std::min(sizeof eight, text.size() - at));
      numbers.push_back(eight);
    }
  }
  template <class T>
  requires(!Plain<T>) void put(T& parts) { fields(*this, parts); }
  void put_size(std::uint64_t size) { put(size); }
};

/// Throws std::runtime_error where the list is too short: it may come from a process that is not trusted.
class NumberReader {
 public:
  explicit NumberReader(std::span<const double> numbers) : left_(numbers) {}

  template <class... Parts>
  void operator()(Parts&... parts) {
    (take(parts), ...);
  }

 private:
  std::span<const double> next(std::size_t count) {
    if (count > left_.size()) throw std::runtime_error("a list of numbers is cut");
    const auto found = left_.first(count);
    left_ = left_.subspan(count);
    return found;
  }
  void take(double& value) { value = next(1).front(); }
  template <Plain T>
  void take(T& value) {
    value = static_cast<T>(std::bit_cast<std::uint64_t>(next(1).front()));
  }
  void take(Tensor& tensor) { std::memcpy(tensor.data(), next(9).data(), sizeof(double) * 9); }
  void take(Vector3& vector) { std::memcpy(vector.data(), next(3).data(), sizeof(double) * 3); }
  void take(std::vector<double>& list) {
    const auto found = next(size());
    list.assign(found.begin(), found.end());
  }
  template <class T>
  void take(std::vector<T>& list) {
    const std::size_t count = size();
    if (count > left_.size()) throw std::runtime_error("a list of numbers is cut");  // every item takes one at least
    list.resize(count);
    for (T& item : list) take(item);
  }
  void take(std::string& text) {
    const std::size_t length = size();
    if (length / sizeof(double) > left_.size()) throw std::runtime_error("a list of numbers is cut");
    const auto found = next((length + sizeof(double) - 1) / sizeof(double));
    text.resize(length);
    if (length > 0) std::memcpy(text.data(), found.data(), length);
  }
  template <class T>
  requires(!Plain<T>) void take(T& parts) { fields(*this, parts); }
  std::size_t size() {
    std::uint64_t count = 0;
    take(count);
    return count;
  }

  std::span<const double> left_;
};

}  // namespace assay
