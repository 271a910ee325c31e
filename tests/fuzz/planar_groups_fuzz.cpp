// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.h"
#include "fuzz/planar_properties.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return aresta::test::fuzz(aresta::test::check_planar_groups, data, size);
}
