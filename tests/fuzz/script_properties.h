// SPDX-License-Identifier: Apache-2.0
// What scripts of operators must hold, right or wrong: a line that is refused says in which line and why and leaves all
// complexes as they were; every other leaves complexes without findings; in the end all is undone to the dump at the
// start, and redone.
#pragma once

#include <vector>

#include "document/complex_shape.h"
#include "fuzz/properties.h"
#include "script/interpreter.h"

namespace aresta::test {

/// Runs a script line by line, goes on past errors, and looks at the complexes that the variables m and n hold.
class ScriptRun {
 public:
  ScriptRun();

  void run(const std::string& line);
  void finish();

  /// Of the variable m; null when it holds none.
  const Complex* complex() const;
  std::size_t accepted() const { return accepted_; }
  std::size_t refused() const { return refused_; }
  const std::string& wrong() const { return wrong_; }  ///< empty: as it should be

 private:
  struct Known {
    document::ShapePtr shape;
    const document::ComplexShape* complex;
    std::string start, last;  ///< dumps
  };
  const document::ComplexShape* find(const char* name) const;
  void meet(const char* name);
  void judge_error(const Error& error);
  void judge_complexes(bool may_change);
  void undo_and_redo(const Known& known);
  void say(const std::string& what);

  document::Session session_;
  script::Interpreter interpreter_;
  std::vector<Known> known_;
  std::size_t accepted_ = 0, refused_ = 0;
  std::string wrong_;
};

/// A script as text, its lines one after the other.
Verdict check_script(std::string_view text);

/// The script that ScriptWriter makes of the bytes; what is wrong ends with its text.
Verdict check_script_of_bytes(std::string_view bytes);

}  // namespace aresta::test
