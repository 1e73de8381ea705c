// SPDX-License-Identifier: BSD-3-Clause
// Values of particles that are the same in many frames, kept once.
#pragma once

#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace assay::drivers {

/// As a vector. Copies share the values until one of them is changed: what is not const is a copy of its own.
template <class T>
class SharedColumn {
 public:
  SharedColumn() = default;
  SharedColumn(std::vector<T> values) {
    if (!values.empty()) values_ = std::make_shared<std::vector<T>>(std::move(values));
  }
  operator const std::vector<T>&() const { return all(); }

  std::size_t size() const { return all().size(); }
  bool empty() const { return !values_ || values_->empty(); }
  const T& operator[](std::size_t k) const { return (*values_)[k]; }
  T& operator[](std::size_t k) { return own()[k]; }
  auto begin() const { return all().begin(); }
  auto end() const { return all().end(); }
  auto begin() { return own().begin(); }
  auto end() { return own().end(); }
  void push_back(const T& value) { own().push_back(value); }
  void clear() { values_.reset(); }

  /// Takes the values of another column where they are the same.
  void share(const SharedColumn& other) {
    if (values_ != other.values_ && values_ && other.values_ && *values_ == *other.values_) values_ = other.values_;
  }

 private:
  const std::vector<T>& all() const {
    static const std::vector<T> none;
    return values_ ? *values_ : none;
  }
  std::vector<T>& own() {
    if (!values_) {
      values_ = std::make_shared<std::vector<T>>();
    } else if (values_.use_count() > 1) {
      values_ = std::make_shared<std::vector<T>>(*values_);
    }
    return *values_;
  }
  std::shared_ptr<std::vector<T>> values_;
};

}  // namespace assay::drivers
