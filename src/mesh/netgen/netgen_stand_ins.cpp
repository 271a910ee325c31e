// SPDX-License-Identifier: Apache-2.0
// Debian's libmesh leaves three functions of file formats to libinterface, which drags in OpenGL and X11. Nothing here
// calls them; they exist so that the library loads, and say so if somebody does call them. Their names are the
// library's.
#include <meshing.hpp>
#include <stdexcept>

namespace netgen {

// NOLINTBEGIN(readability-identifier-naming): the library looks for these names
void ReadFile(Mesh&, const std::string&) {
  throw std::logic_error("file formats are not part of this mesher");
}
bool WriteUserFormat(const std::string&, const Mesh&, const std::string&) {
  throw std::logic_error("file formats are not part of this mesher");
}
void RegisterUserFormats(Array<const char*>&, Array<const char*>&) {}
// NOLINTEND(readability-identifier-naming)

}  // namespace netgen
