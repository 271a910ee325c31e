// SPDX-License-Identifier: Apache-2.0
// Runs a script and gives what it printed, or the error's line.
#pragma once

#include <string>

#include "document/commands.h"
#include "script/interpreter.h"

namespace aresta::script {

inline const document::Registry& language() {
  static const document::Registry registry = [] {
    document::Registry r;
    register_language(r);
    return r;
  }();
  return registry;
}

/// The language with all commands on models.
inline const document::Registry& modeller() {
  static const document::Registry registry = [] {
    document::Registry r;
    document::register_modelling(r);
    register_language(r);
    return r;
  }();
  return registry;
}

struct Ran {
  std::string printed;
  std::string error;  ///< empty when all went well
};

inline Ran run_text(const std::string& text, document::Digits digits = document::Digits::shortest,
                    const std::atomic<bool>* cancel = nullptr, const document::Registry& registry = language()) {
  Ran ran;
  document::Session session;
  session.registry = &registry;
  session.digits = digits;
  session.context.cancel = cancel;
  session.print = [&ran](const std::string& s) -> Status {
    ran.printed += s;
    return {};
  };
  Interpreter interpreter(session);
  const Status status = interpreter.run(text, "t.ars");
  if (!status) ran.error = status.error().to_line();
  return ran;
}

inline Ran run_shapes(const std::string& text) {
  return run_text(text, document::Digits::shortest, nullptr, modeller());
}

}  // namespace aresta::script
