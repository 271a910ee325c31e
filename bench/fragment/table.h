// SPDX-License-Identifier: Apache-2.0
// The rows that the benchmark prints: what each library answered to one problem, whether they agree, and a line for
// each figure that has a bound. A ratio counts only where the peer ran and agrees.
#pragma once

#include <string>
#include <vector>

#include "fragment/alone.h"

namespace aresta::bench {

class Table {
 public:
  /// Begins a problem. `volume` is the true one of all its solids, from elsewhere than any library; 0: ours is the one
  /// that the others are held against.
  void begin(std::string problem, double volume);

  /// Runs and prints one library; ours first. Cells or volumes that are not as expected are a line DIFFERS, no answer
  /// is a line NONE. No answer of ours is a failure; that of a peer is one where a ratio to it is asked for.
  /// `relative`: how far volumes may be apart.
  void run(const std::string& library, const std::function<Answer()>& work, double relative = 1e-9);

  /// The current problem's figures; the library is named as in `run`. Lines `ok` or `BEYOND`; a ratio to who does not
  /// agree is 0.
  void faster_than(const std::string& library, double at_least);
  void at_most(const std::string& what, double value, double limit);

  std::optional<Answer> ours() const;
  double peak_megabytes() const { return 1e-6 * static_cast<double>(peak_bytes_); }  ///< of our own run

  bool all_within() const { return all_within_; }

 private:
  void line(bool within, const std::string& what, double value, const char* relation, double limit);

  struct Entry {
    std::string library;
    std::optional<Answer> answer;
    bool agrees = false;
  };
  std::string problem_;
  double volume_ = 0;
  std::vector<Entry> entries_;
  std::size_t peak_bytes_ = 0;
  bool all_within_ = true;
};

}  // namespace aresta::bench
