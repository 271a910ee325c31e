#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The script in README.md is examples/first.ars, word for word (which is a test of its own), and what the page links to exists.
set -eu
cd "$(dirname "$0")/../.."
status=0
sed -n '/^from aresta import/,$p' examples/first.ars | while IFS= read -r line; do
  [ -z "$line" ] || grep -qxF -- "$line" README.md || { echo "README.md lacks this line of examples/first.ars: $line" && exit 1; }
done || status=1
for target in $(grep -oE '\]\([^)#]+\)' README.md | sed 's/^](//; s/)$//' | grep -v '^http'); do
  [ -e "$target" ] || { echo "README.md links to $target, which does not exist" && status=1; }
done
exit $status
