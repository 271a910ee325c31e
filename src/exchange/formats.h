// SPDX-License-Identifier: Apache-2.0
// The readers and writers behind exchange.h, one pair per format. Readers get the file's bytes, writers give them.
#pragma once

#include <string>

#include "exchange/exchange.h"

namespace aresta {

struct ReadArguments {
  const std::string& data;
  const ImportOptions& options;
  ImportReport& report;
  const Context& context;
};

Result<Model> read_step(const ReadArguments& in);
Result<Model> read_brep(const ReadArguments& in);
Result<Model> read_stl(const ReadArguments& in);
Result<Model> read_obj(const ReadArguments& in);
Result<Model> read_ply(const ReadArguments& in);
Result<Model> read_off(const ReadArguments& in);

Result<std::string> write_step(const Model& model, const ExportOptions& options, const Context& context);
Result<std::string> write_brep(const Model& model, const ExportOptions& options, const Context& context);
Result<std::string> write_stl(const Model& model, const ExportOptions& options, const Context& context);
Result<std::string> write_obj(const Model& model, const ExportOptions& options, const Context& context);

}  // namespace aresta
