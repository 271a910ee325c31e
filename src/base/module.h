// SPDX-License-Identifier: Apache-2.0
// Modules loaded when used: code whose dependencies drag in X11 or a GUI is kept out of the core libraries.
#pragma once

#include <string>

#include "base/result.h"

namespace aresta {

/// The address of function `symbol` (extern "C") in module `name` (file libaresta_NAME.so).
/// Looked for in $ARESTA_MODULE_PATH, then in `aresta/` and `modules/` and `../modules/` beside the library that holds
/// this function. Loaded once and kept. Error: module_missing, with the loader's reason.
Result<void*> module_function(const std::string& name, const std::string& symbol);

}  // namespace aresta
