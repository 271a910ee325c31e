// SPDX-License-Identifier: Apache-2.0
#include "script/ast.h"

#include <array>

namespace aresta::script {

namespace {

struct NamedOp {
  const char* text;
  Op op;
};
constexpr std::array named_ops = {NamedOp{"+", Op::add},           NamedOp{"-", Op::subtract},
                                  NamedOp{"*", Op::multiply},      NamedOp{"/", Op::divide},
                                  NamedOp{"//", Op::floor_divide}, NamedOp{"%", Op::modulo},
                                  NamedOp{"**", Op::power},        NamedOp{"&", Op::bit_and},
                                  NamedOp{"==", Op::equal},        NamedOp{"!=", Op::not_equal},
                                  NamedOp{"<", Op::less},          NamedOp{"<=", Op::less_equal},
                                  NamedOp{">", Op::greater},       NamedOp{">=", Op::greater_equal},
                                  NamedOp{"in", Op::in},           NamedOp{"not in", Op::not_in},
                                  NamedOp{"is", Op::is},           NamedOp{"is not", Op::is_not}};

}  // namespace

const char* op_text(Op op) {
  for (const NamedOp& n : named_ops) {
    if (n.op == op) return n.text;
  }
  return "";
}

std::optional<Op> op_named(std::string_view text) {
  for (const NamedOp& n : named_ops) {
    if (text == n.text) return n.op;
  }
  return std::nullopt;
}

}  // namespace aresta::script
