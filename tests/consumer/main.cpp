// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "base/result.h"
#include "math/transform.h"

int main() {
  const aresta::Error error{aresta::errors::invalid_argument, "the size is -1"};
  std::printf("%s\n", error.to_line().c_str());
  return 0;
}
