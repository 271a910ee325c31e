// SPDX-License-Identifier: Apache-2.0
// From a shape read from a file to a model: conversion, repair when it cannot be taken as it is, labels.
#pragma once

#include "exchange/formats.h"
#include "exchange/step/step_module.h"
#include "occt/to_model.h"

namespace aresta {

/// The model of a shape. When it cannot be converted and repair is allowed, the library's shape fixing is tried once;
/// the report says so. Names, colours and layers go to regions (of parts with solids), faces, edges or vertices.
Result<Model> import_shape(const OcctShape& shape, const std::vector<LabelledShape>& labelled,
                           const ImportOptions& options, ImportReport& report, const Context& context);

}  // namespace aresta
