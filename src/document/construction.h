// SPDX-License-Identifier: Apache-2.0
// Parameters that constructing commands share, and how they become options.
#pragma once

#include <string>
#include <vector>

#include "construct/options.h"
#include "document/shape.h"

namespace aresta::document {

/// A length greater than 0; one that may be 0.
Parameter length(std::string name, std::string doc);
Parameter size(std::string name, std::string doc);
/// `at`, with its meaning.
Parameter at(std::string doc);
/// `axis`.
Parameter axis();
/// `names`: name the faces by what they are.
Parameter names();
/// at, axis, names.
std::vector<Parameter> standing();
/// at, axis, patches, seam, names.
std::vector<Parameter> round();

ConstructOptions construct_options(const Call& call);
Placement placement(const Call& call);
Patches patches(const Call& call);

/// A whole model as a value.
Result<Value> made(Result<Model> model);

}  // namespace aresta::document
