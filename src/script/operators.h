// SPDX-License-Identifier: Apache-2.0
// What the operators, brackets and methods of the language do to values. As in Python, but whole numbers have 64 bits
// and say so when they overflow, real numbers never silently become infinite, and sequences have a greatest length.
#pragma once

#include "document/registry.h"
#include "script/ast.h"

namespace aresta::script {

/// Longest list, tuple or materialised range; longest text in bytes.
inline constexpr std::uint64_t max_items = std::uint64_t{1} << 24;
inline constexpr std::uint64_t max_text = std::uint64_t{1} << 26;

/// a op b into `out` (which may be a or b). + - & of shapes are the regularised union, difference and intersection of
/// the session's registry. Errors: script.type, script.zero_division, script.overflow, script.too_large, and the
/// booleans' own.
Status binary(Op op, const document::Value& a, const document::Value& b, document::Session& session,
              document::Value& out);

Status negate(const document::Value& a, document::Value& out);

/// Less-than of numbers, texts and sequences. Error: script.type.
Status less(const document::Value& a, const document::Value& b, bool& out);

/// container[key]. Errors: script.type, script.index.
Status index(const document::Value& container, const document::Value& key, document::Value& out);
/// container[key] = value, of lists. Errors: script.type, script.index.
Status assign_index(const document::Value& container, const document::Value& key, const document::Value& value);
/// container[start:stop:step]; None for what is absent.
Status slice(const document::Value& container, const document::Value& start, const document::Value& stop,
             const document::Value& step, document::Value& out);

/// Length of a text (in characters), list, tuple or range. Error: script.type.
Result<std::uint64_t> length(const document::Value& v);
/// All items of a list, tuple, range or text, copied. Errors: script.type, script.too_large.
Result<std::vector<document::Value>> items_of(const document::Value& v);

/// target.name(arguments): append, extend, insert, pop, index, count, reverse of lists; join, split, strip, upper,
/// lower, replace, startswith, endswith of texts.
Status method(const document::Value& target, const std::string& name, std::vector<document::Value> arguments,
              document::Value& out);

/// A value by a format such as ".3f", "8.2e", ">10", "05d". Errors: script.value, script.type.
Result<std::string> format(const document::Value& value, std::string_view spec);

}  // namespace aresta::script
