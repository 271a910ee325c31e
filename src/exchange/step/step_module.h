// SPDX-License-Identifier: Apache-2.0
// What passes between exchange/ and its STEP module.
#pragma once

#include <string>
#include <vector>

#include "base/context.h"
#include "occt/shape.h"

namespace aresta {

struct LabelledShape {
  OcctShape shape;    ///< a part, or a face, edge or vertex of one
  std::string name;   ///< empty: none
  std::string color;  ///< "#rrggbb"; empty: none
  std::string layer;
};

struct StepContents {
  OcctShape whole;                      ///< a compound of all parts in their places
  std::vector<LabelledShape> labelled;  ///< outer ones before inner ones
  std::string file_unit;                ///< as the file names it
  std::vector<std::string> notes;
};

struct StepParts {
  std::vector<LabelledShape> parts;      ///< written one by one, in this order
  std::vector<LabelledShape> subshapes;  ///< of the parts
  std::string title, description;
  double length_unit = 1e-3;
};

/// extern "C" aresta_step_read and aresta_step_write. `length_unit`: metres per unit of the shapes. Names of faces,
/// edges and vertices are asked for only in files of our own: in others the library can crash on entities it does not
/// know. The result is given back through the last argument: a function of C returns no class.
using StepReadFunction = void (*)(const std::string& data, bool subshape_names, double length_unit,
                                  const Context& context, Result<StepContents>* contents);
using StepWriteFunction = void (*)(const StepParts& parts, const Context& context, Result<std::string>* text);

}  // namespace aresta
