// SPDX-License-Identifier: Apache-2.0
// Scripts of operators from bytes: most lines call an operator with parts that are there, some are spoilt. The same
// bytes give the same script everywhere.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "topology/complex.h"

namespace aresta::test {

class ScriptWriter {
 public:
  explicit ScriptWriter(std::string_view bytes) : bytes_(bytes) {}

  bool at_end() const { return at_ >= bytes_.size(); }
  /// The next line, for the complex that m holds now; null when it holds none.
  std::string line(const Complex* m);

 private:
  struct Call {
    std::string name;
    std::vector<std::string> arguments;
    std::string text() const;
  };

  /// Zero when the bytes are used up.
  std::size_t below(std::size_t n);
  bool chance(int percent) { return below(100) < static_cast<std::size_t>(percent); }
  std::string flag() { return chance(50) ? "True" : "False"; }
  std::string side() { return chance(50) ? "0" : "1"; }
  template <class IdType, class Range>
  IdType any(const Range& range);
  template <class IdType, class Range>
  std::string number(const Range& range);

  std::string start();
  std::string other_line();
  Call call(const Complex& k);
  std::string region_at(const Complex& k, VertexId v);
  std::string corner(const Complex& k, FaceId f);
  std::string circuit(const Complex& k);
  std::string items(const Complex& k);
  void spoil(Call& call);

  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace aresta::test
