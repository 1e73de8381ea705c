// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/table_pack.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "harness/material/offer.hpp"

namespace assay::adapters {

namespace {

class Writer {
 public:
  template <class T>
  void number(T value) {
    static_assert(std::is_trivially_copyable_v<T>);
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    out.append(bytes, sizeof value);
  }
  void text(const char* words) {
    const std::string copy = words ? words : "";
    number(static_cast<std::uint32_t>(copy.size()));
    out += copy;
  }
  std::string out;
};

class Reader {
 public:
  Reader(const std::string& bytes, std::deque<std::string>& words) : bytes_(bytes), words_(words) {}
  template <class T>
  T number() {
    T value;
    if (at_ + sizeof value > bytes_.size()) throw std::runtime_error("the worker's answer is cut");
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  const char* text() {
    const auto size = number<std::uint32_t>();
    if (size > bytes_.size() - at_) throw std::runtime_error("the worker's answer is cut");
    words_.push_back(bytes_.substr(at_, size));
    at_ += size;
    return words_.back().c_str();
  }

 private:
  const std::string& bytes_;
  std::deque<std::string>& words_;
  std::size_t at_ = 0;
};

template <class... Extensions>
void abilities(const assay_material& table, Writer& w) {
  (w.number(bool(Offer<Extensions>(table, nullptr))), ...);
}

}  // namespace

std::string packed(const assay_material& table) {
  Writer w;
  for (const char* words : {table.name, table.version, table.licence, table.doc}) w.text(words);
  w.number(table.symmetry);
  w.number(table.flags);
  w.number(table.parameter_count);
  w.number(table.state_count);
  for (std::uint32_t i = 0; i < table.parameter_count; ++i) {
    const assay_parameter& p = table.parameters[i];
    for (const char* words : {p.name, p.unit, p.doc}) w.text(words);
    for (const double value : {p.default_value, p.lower, p.upper}) w.number(value);
  }
  for (std::uint32_t i = 0; i < table.state_count; ++i) {
    const assay_state_variable& v = table.state[i];
    for (const char* words : {v.name, v.unit, v.doc}) w.text(words);
    w.number(v.kind);
    w.number(v.role);
  }
  abilities<assay_rate, assay_tangent, assay_energy, assay_wave_speed, assay_closed_form, assay_reason>(table, w);
  const auto* example = static_cast<const assay_example*>(extension_of(&table, ASSAY_EXTENSION_EXAMPLE));
  const bool has_values = example && example->struct_size >= sizeof(assay_example) && example->parameters;
  w.number(has_values);
  for (std::uint32_t i = 0; has_values && i < table.parameter_count; ++i) w.number(example->parameters[i]);
  const auto* symmetry = static_cast<const assay_symmetry*>(extension_of(&table, ASSAY_EXTENSION_SYMMETRY));
  const bool whole = symmetry && symmetry->struct_size >= sizeof(assay_symmetry);
  w.number(whole ? symmetry->material_class : std::int32_t{0});
  return w.out;
}

void unpack(const std::string& bytes, UnpackedTable& out) {
  Reader r(bytes, out.words);
  assay_material& t = out.table;
  t.abi_major = ASSAY_ABI_MAJOR;
  t.struct_size = sizeof t;
  t.name = r.text(), t.version = r.text(), t.licence = r.text(), t.doc = r.text();
  t.symmetry = r.number<std::int32_t>();
  t.flags = r.number<std::uint32_t>();
  t.parameter_count = r.number<std::uint32_t>();
  t.state_count = r.number<std::uint32_t>();
  for (std::uint32_t i = 0; i < t.parameter_count; ++i) {
    const char *name = r.text(), *unit = r.text(), *doc = r.text();
    const auto value = r.number<double>(), lower = r.number<double>(), upper = r.number<double>();
    out.parameters.push_back({name, unit, value, lower, upper, doc});
  }
  for (std::uint32_t i = 0; i < t.state_count; ++i) {
    const char *name = r.text(), *unit = r.text(), *doc = r.text();
    const auto kind = r.number<std::int32_t>(), role = r.number<std::int32_t>();
    out.state.push_back({name, unit, kind, role, doc});
  }
  TableAbilities& a = out.abilities;
  for (bool* ability : {&a.rate, &a.tangent, &a.energy, &a.wave_speed, &a.closed_form, &a.reason}) {
    *ability = r.number<bool>();
  }
  if (r.number<bool>()) {
    for (std::uint32_t i = 0; i < t.parameter_count; ++i) a.example.push_back(r.number<double>());
  }
  a.material_class = r.number<std::int32_t>();
  t.parameters = out.parameters.data();
  t.state = out.state.data();
}

}  // namespace assay::adapters
