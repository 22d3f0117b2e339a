/// Target of a key of the model file: the last part of its row in the field table.
///
/// Values are bound from the root downwards, in the table's order. A row receives the object of its group and returns
/// the object for the values below it. The types of both are known, so that a row under the wrong group is detected
/// when the table is made (modelfile/schema/field_tree.h).
#pragma once

#include <any>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <typeindex>
#include <typeinfo>
#include <utility>
#include <variant>
#include <vector>

#include "base/enum_names.h"
#include "base/require.h"

namespace overbend {

struct FieldValue;

/// Contains a `T*`, or a `T` that lives only while the values below it are bound.
using Target = std::any;

struct Member {
  using Default = std::variant<double, std::int64_t, std::string>;

  /// Stores a value in its member; returns the object for the values below it, empty if other code binds them. If `put`
  /// is empty, the values below belong to the same object as the row itself.
  std::function<Target(Target& owner, const FieldValue& value)> put = {};
  std::type_index owner = typeid(void);        ///< Type of the object that the row needs; void if `put` is empty.
  std::type_index below = typeid(void);        ///< Type of the object for the values below; void if there is none.
  std::optional<Default> standard = {};        ///< Default of the member, if the row states it.
  std::vector<std::string> choice_names = {};  ///< Texts of an enumeration.
};

/// Returns the object of a target.
template <typename T>
T& object(Target& target) {
  if (T* const* pointer = std::any_cast<T*>(&target)) return **pointer;
  T* held = std::any_cast<T>(&target);
  require(held != nullptr, "a row of the field table belongs to the type of its group");
  return *held;
}

namespace member_values {

void read(const FieldValue& value, double& target);
void read(const FieldValue& value, int& target);
void read(const FieldValue& value, std::uint64_t& target);
void read(const FieldValue& value, std::string& target);
const std::string& text(const FieldValue& value);

template <HasEnumNames Enum>
void read(const FieldValue& value, Enum& target) {
  const std::optional<Enum> found = from_enum_name<Enum>(text(value));
  require(found.has_value(), "an accepted choice is one of the enumeration's names");
  target = *found;
}

template <typename T>
void read(const FieldValue& value, std::optional<T>& target) {
  read(value, target.emplace());
}

inline Member::Default standard(double value) {
  return value;
}
inline Member::Default standard(const std::string& value) {
  return value;
}
template <typename T>
Member::Default standard(T value) {
  if constexpr (HasEnumNames<T>) {
    return std::string(enum_name(value));
  } else {
    static_assert(std::is_integral_v<T>);
    return static_cast<std::int64_t>(value);
  }
}

template <typename T>
struct Plain {
  using type = T;
};
template <typename T>
struct Plain<std::optional<T>> {
  using type = T;
};

template <typename T>
std::vector<std::string> choice_names() {
  if constexpr (HasEnumNames<T>) return enum_names<T>();
  return {};
}

}  // namespace member_values

namespace field_rows {

/// Returns the row with a default that the member itself does not have.
inline Member with_default(Member row, Member::Default standard) {
  row.standard = std::move(standard);
  return row;
}

/// Member with a custom `put(owner, value)`.
template <typename Owner, typename Put>
Member taken_by(Put put) {
  Member member;
  member.owner = typeid(Owner);
  member.put = [put](Target& owner, const FieldValue& value) {
    put(object<Owner>(owner), value);
    return Target();
  };
  return member;
}

/// Items of a list of plain values.
template <typename T>
Member appends_value() {
  return taken_by<std::vector<T>>(
      [](std::vector<T>& list, const FieldValue& value) { member_values::read(value, list.emplace_back()); });
}

/// Member whose values below belong to the object returned by `open(owner, value)`: a reference or a value.
template <typename Owner, typename Open>
Member opened_by(Open open) {
  using Below = std::invoke_result_t<Open, Owner&, const FieldValue&>;
  Member member;
  member.owner = typeid(Owner);
  member.below = typeid(std::remove_reference_t<Below>);
  member.put = [open](Target& owner, const FieldValue& value) -> Target {
    if constexpr (std::is_reference_v<Below>) {
      return &open(object<Owner>(owner), value);
    } else {
      return open(object<Owner>(owner), value);
    }
  };
  return member;
}

/// Stores the value in this member. The row describes the meaning of a missing key in a text.
template <typename Owner, typename T>
Member fills(T Owner::*member) {
  Member row =
      taken_by<Owner>([member](Owner& owner, const FieldValue& value) { member_values::read(value, owner.*member); });
  row.choice_names = member_values::choice_names<typename member_values::Plain<T>::type>();
  return row;
}

/// The same with the member's initial value as the default.
template <typename Owner, typename T>
Member defaults(T Owner::*member) {
  Member row = fills(member);
  row.standard = member_values::standard(Owner{}.*member);
  return row;
}

/// The keys below fill the object in this member.
template <typename Owner, typename T>
Member enters(T Owner::*member) {
  return opened_by<Owner>([member](Owner& owner, const FieldValue&) -> T& { return owner.*member; });
}

/// The same for an optional object, which exists only if its group is given.
template <typename Owner, typename T>
Member enters(std::optional<T> Owner::*member) {
  return opened_by<Owner>([member](Owner& owner, const FieldValue&) -> T& { return (owner.*member).emplace(); });
}

/// A given list replaces the one in this member.
template <typename Owner, typename T>
Member enters(std::vector<T> Owner::*member) {
  return opened_by<Owner>([member](Owner& owner, const FieldValue&) -> std::vector<T>& {
    (owner.*member).clear();
    return owner.*member;
  });
}

/// Item of such a list.
template <typename T>
Member appends() {
  return opened_by<std::vector<T>>([](std::vector<T>& list, const FieldValue&) -> T& { return list.emplace_back(); });
}

/// Item of such a list, with a default name such as "coating 2".
template <typename T>
Member appends_named(const char* kind) {
  return opened_by<std::vector<T>>([kind](std::vector<T>& list, const FieldValue&) -> T& {
    T& item = list.emplace_back();
    item.name = kind + (" " + std::to_string(list.size()));
    return item;
  });
}

/// Applies a row for a member of `Part` to a group whose object is the `Owner` of such a part.
template <typename Owner, typename Part>
Member through(Part Owner::*part, const Member& row) {
  if (!row.put) return enters(part);
  Member outer = row;
  outer.owner = typeid(Owner);
  outer.put = [part, put = row.put](Target& owner, const FieldValue& value) {
    Target inner = &(object<Owner>(owner).*part);
    return put(inner, value);
  };
  return outer;
}

/// The same for an optional part, which exists only if one of its keys is given.
template <typename Owner, typename Part>
Member through(std::optional<Part> Owner::*part, const Member& row) {
  const auto existing = [part](Target& owner) -> Part& {
    std::optional<Part>& found = object<Owner>(owner).*part;
    return found ? *found : found.emplace();
  };
  Member outer = row;
  outer.owner = typeid(Owner);
  if (!row.put) outer.below = typeid(Part);
  outer.put = [existing, put = row.put](Target& owner, const FieldValue& value) -> Target {
    Target inner = &existing(owner);
    return put ? put(inner, value) : inner;
  };
  return outer;
}

/// Values read by the row of their list, or by another reader.
Member read_elsewhere();

}  // namespace field_rows
}  // namespace overbend
