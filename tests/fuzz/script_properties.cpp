// SPDX-License-Identifier: Apache-2.0
#include "fuzz/script_properties.h"

#include "document/commands.h"
#include "fuzz/script_writer.h"
#include "topology/check.h"
#include "topology/dump.h"

namespace aresta::test {

namespace {

const document::Registry& registry() {
  static const document::Registry all = [] {
    document::Registry r;
    script::register_language(r);
    document::register_modelling(r);
    return r;
  }();
  return all;
}

constexpr const char* file = "script";

}  // namespace

ScriptRun::ScriptRun() : session_{.registry = &registry()}, interpreter_(session_) {
  session_.print = [](const std::string&) { return Status(); };
}

void ScriptRun::run(const std::string& line) {
  if (!wrong_.empty()) return;
  // As the lines of one script, so that the place of an error tells the line.
  const std::size_t before = accepted_ + refused_;
  const Status status = interpreter_.run(std::string(before, '\n') + line, file);
  ++(status.ok() ? accepted_ : refused_);
  if (!status.ok()) judge_error(status.error());
  // What the language itself refuses, as a result that cannot be unpacked, comes after the operator.
  judge_complexes(status.ok() || status.error().code.number >= 930);
  meet("m");
  meet("n");
}

void ScriptRun::judge_error(const Error& error) {
  const std::string place = std::string(file) + ":" + std::to_string(accepted_ + refused_) + ":";
  if (error.location.substr(0, place.size()) != place) return say("an error without its line");
  if (error.message.empty() || error.code.number < 100 || error.code == errors::internal) {
    say("an error that does not say what it is: " + error.to_line());
  }
}

void ScriptRun::judge_complexes(bool may_change) {
  for (Known& known : known_) {
    const Complex& k = known.complex->complex();
    std::string now = dump(k);
    if (now == known.last) continue;
    if (!may_change) return say("a line that is refused changes a complex");
    if (const auto findings = check_structure(k, StructureLevel::shells); !findings.empty()) {
      return say("the checker finds: " + describe(findings.front()));
    }
    known.last = std::move(now);
  }
}

const document::ComplexShape* ScriptRun::find(const char* name) const {
  const document::Value* value = interpreter_.get(name);
  if (value == nullptr || !value->is(document::Value::Kind::shape)) return nullptr;
  return dynamic_cast<const document::ComplexShape*>(value->shape().get());
}

const Complex* ScriptRun::complex() const {
  const auto* shape = find("m");
  return shape == nullptr ? nullptr : &shape->complex();
}

/// A complex that the run has not seen yet.
void ScriptRun::meet(const char* name) {
  const auto* shape = find(name);
  if (shape == nullptr) return;
  for (const Known& known : known_) {
    if (known.complex == shape) return;
  }
  const std::string text = dump(shape->complex());
  known_.push_back({interpreter_.get(name)->shape(), shape, text, text});
  const auto findings = check_structure(shape->complex(), StructureLevel::shells);
  if (!findings.empty()) say("the checker finds in what is read: " + describe(findings.front()));
}

void ScriptRun::finish() {
  for (const Known& known : known_) {
    if (wrong_.empty()) undo_and_redo(known);
  }
}

void ScriptRun::undo_and_redo(const Known& known) {
  interpreter_.set("x", document::Value(known.shape));
  const std::size_t steps = known.complex->state().done.size();
  const auto step = [&](const std::string& command) {
    const Status status = interpreter_.run(command + "(x)", file);
    if (!status.ok()) say(command + " is refused: " + status.error().to_line());
  };
  for (std::size_t i = 0; i < steps && wrong_.empty(); ++i) step("undo");
  if (wrong_.empty() && dump(known.complex->complex()) != known.start) say("undone, it has another dump than before");
  for (std::size_t i = 0; i < steps && wrong_.empty(); ++i) step("redo");
  if (wrong_.empty() && dump(known.complex->complex()) != known.last) say("redone, it has another dump than before");
}

void ScriptRun::say(const std::string& what) {
  if (wrong_.empty()) wrong_ = "line " + std::to_string(accepted_ + refused_) + ": " + what;
}

Verdict check_script(std::string_view text) {
  ScriptRun run;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    run.run(std::string(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  run.finish();
  return {run.refused() == 0, run.wrong()};
}

Verdict check_script_of_bytes(std::string_view bytes) {
  ScriptRun run;
  ScriptWriter writer(bytes);
  std::string text;
  while (!writer.at_end() && run.wrong().empty()) {
    const std::string line = writer.line(run.complex());
    text += line + "\n";
    run.run(line);
  }
  run.finish();
  return {run.refused() == 0, run.wrong().empty() ? "" : run.wrong() + "\n" + text};
}

}  // namespace aresta::test
