// SPDX-License-Identifier: Apache-2.0
#include "fragment/table.h"

#include <cmath>
#include <cstdio>

namespace aresta::bench {

namespace {

constexpr double most_seconds = 120;

bool same(double a, double b, double relative) {
  return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

}  // namespace

void Table::begin(std::string problem, double volume) {
  problem_ = std::move(problem);
  volume_ = volume;
  entries_.clear();
  peak_bytes_ = 0;
}

void Table::run(const std::string& library, const std::function<Answer()>& work, double relative) {
  const Outcome outcome = run_alone(work, most_seconds);
  const bool is_ours = entries_.empty();
  Entry& entry = entries_.emplace_back(Entry{library, outcome.answer});
  if (is_ours) peak_bytes_ = outcome.peak_bytes;
  if (!outcome.answer) {
    std::printf("NONE    %s, %s: %s\n", problem_.c_str(), library.c_str(), outcome.reason.c_str());
    all_within_ = all_within_ && !is_ours;
  } else {
    std::string difference;
    const Answer& a = *outcome.answer;
    const auto& own = entries_.front().answer;
    // Who does not tell the cells of operands from voids is held against our sum of both.
    const double solids = a.solid_volume != 0 || !own ? a.solid_volume : own->solid_volume + a.volume - own->volume;
    const double expected = volume_ != 0 ? volume_ : own ? own->solid_volume : solids;
    if (!same(solids, expected, relative)) difference = "the true volume is " + std::to_string(expected);
    if (own && own->cells != a.cells) difference = "we found " + std::to_string(own->cells) + " cells";
    entry.agrees = difference.empty();
    std::printf("%-28s %-28s %12.6f s %9llu cells, volume %.9g, solid %.9g, peak %.0f MB\n", problem_.c_str(),
                library.c_str(), a.seconds, static_cast<unsigned long long>(a.cells), a.volume, solids,
                1e-6 * static_cast<double>(outcome.peak_bytes));
    if (!difference.empty()) {
      all_within_ = false;
      std::printf("DIFFERS %s, %s: %s\n", problem_.c_str(), library.c_str(), difference.c_str());
    }
  }
  std::fflush(stdout);
}

std::optional<Answer> Table::ours() const {
  return entries_.empty() || !entries_.front().agrees ? std::nullopt : entries_.front().answer;
}

void Table::faster_than(const std::string& library, double at_least) {
  double ratio = 0;
  for (const Entry& entry : entries_) {
    if (entry.library == library && entry.agrees && ours()) ratio = entry.answer->seconds / ours()->seconds;
  }
  line(ratio >= at_least, "times faster than " + library, ratio, "at least", at_least);
}

void Table::at_most(const std::string& what, double value, double limit) {
  line(value <= limit, what, value, "at most", limit);
}

void Table::line(bool within, const std::string& what, double value, const char* relation, double limit) {
  all_within_ = all_within_ && within;
  std::printf("%-7s %-64s %12.4g   %s %g\n", within ? "ok" : "BEYOND", (problem_ + ", " + what).c_str(), value,
              relation, limit);
}

}  // namespace aresta::bench
