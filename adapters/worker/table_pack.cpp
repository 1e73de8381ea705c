// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/table_pack.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "adapters/worker/operations.hpp"

namespace assay::adapters {

namespace {

class Writer {
 public:
  template <class T>
  void item(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void item(const char* words) {
    const std::string copy = words ? words : "";
    item(copy.size());
    out += copy;
  }
  template <class List>
  void size(const List& list) {
    item(list.size());
  }
  std::string out;
};

class Reader {
 public:
  Reader(const std::string& bytes, std::deque<std::string>& words) : left_(bytes), words_(words) {}
  template <class T>
  void item(T& value) {
    std::memcpy(&value, taken(sizeof value).data(), sizeof value);
  }
  void item(const char*& words) {
    std::size_t size = 0;
    item(size);
    words = words_.emplace_back(taken(size)).c_str();
  }
  template <class List>
  void size(List& list) {
    std::size_t count = 0;
    item(count);
    if (count > left_.size()) cut();
    list.resize(count);
  }

 private:
  [[noreturn]] static void cut() { throw std::runtime_error("the worker's answer is cut"); }
  std::string_view taken(std::size_t size) {
    if (size > left_.size()) cut();
    const std::string_view found = left_.substr(0, size);
    left_.remove_prefix(size);
    return found;
  }
  std::string_view left_;
  std::deque<std::string>& words_;
};

/// Of both, in the same order.
template <class Archive>
void pass(Archive& archive, UnpackedTable& t) {
  const auto all = [&](auto&... items) { (archive.item(items), ...); };
  all(t.table.name, t.table.version, t.table.licence, t.table.doc, t.table.symmetry, t.table.flags);
  archive.size(t.parameters);
  for (assay_parameter& p : t.parameters) all(p.name, p.unit, p.doc, p.default_value, p.lower, p.upper);
  archive.size(t.state);
  for (assay_state_variable& v : t.state) all(v.name, v.unit, v.doc, v.kind, v.role);
  archive.size(t.example);
  for (double& value : t.example) all(value);
  all(t.offered, t.material_class);
}

template <class... Extensions>
std::uint32_t offered_by(const assay_material& table, FunctionList<Extensions...> list) {
  std::uint32_t offered = 0;
  ((offered |= Offer<Extensions>(table, nullptr) ? 1u << place_in<Extensions>(list) : 0), ...);
  return offered;
}

/// An extension that is values; null where it is too short.
template <class Values>
const Values* values_of(const assay_material& table, const char* id) {
  const auto* found = static_cast<const Values*>(extension_of(&table, id));
  return found && found->struct_size >= sizeof(Values) ? found : nullptr;
}

}  // namespace

std::string packed(const assay_material& table) {
  UnpackedTable t;
  t.table.name = table.name, t.table.version = table.version, t.table.licence = table.licence;
  t.table.doc = table.doc, t.table.symmetry = table.symmetry, t.table.flags = table.flags;
  t.parameters.assign(table.parameters, table.parameters + table.parameter_count);
  t.state.assign(table.state, table.state + table.state_count);
  t.offered = offered_by(table, StatusExtensions{});
  static_cast<void>(Offer<assay_reason>(table, nullptr));  // which may throw, too
  const auto* example = values_of<assay_example>(table, ASSAY_EXTENSION_EXAMPLE);
  if (example && example->parameters) t.example.assign(example->parameters, example->parameters + t.parameters.size());
  const auto* symmetry = values_of<assay_symmetry>(table, ASSAY_EXTENSION_SYMMETRY);
  if (symmetry) t.material_class = symmetry->material_class;
  Writer writer;
  pass(writer, t);
  return writer.out;
}

void unpack(const std::string& bytes, UnpackedTable& out) {
  Reader reader(bytes, out.words);
  pass(reader, out);
  out.table.abi_major = ASSAY_ABI_MAJOR;
  out.table.struct_size = sizeof(assay_material);
  out.table.parameter_count = static_cast<std::uint32_t>(out.parameters.size());
  out.table.state_count = static_cast<std::uint32_t>(out.state.size());
  out.table.parameters = out.parameters.data();
  out.table.state = out.state.data();
}

std::size_t state_size_of(const assay_material& table) {
  std::size_t size = 0;
  for (std::uint32_t k = 0; k < table.state_count; ++k)
    size += static_cast<std::size_t>(components_of_kind(table.state[k].kind));
  return size;
}

}  // namespace assay::adapters
