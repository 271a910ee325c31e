// SPDX-License-Identifier: Apache-2.0
// Figures of a model as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "document/info.h"

namespace aresta::app {

using Json = nlohmann::ordered_json;

Json to_json(const document::ModelInfo& info);
/// The JSON text of a program's output: indented, ends with a newline, never throws on text that is no UTF-8.
std::string json_text(const Json& json);

}  // namespace aresta::app
