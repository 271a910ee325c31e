// SPDX-License-Identifier: Apache-2.0
// The library signals failure by exceptions and asks for cancellation through an indicator; here both end. Include only
// where OCCT may be seen.
#pragma once

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>
#include <Standard_Failure.hxx>
#include <exception>
#include <string>

#include "base/context.h"

namespace aresta {

/// "Standard_DomainError: text", fit for a message.
inline std::string describe(const Standard_Failure& failure) {
  std::string text = failure.DynamicType()->Name();
  const char* message = failure.GetMessageString();
  if (message != nullptr && *message != '\0') text += std::string(": ") + message;
  return text;
}

/// The library's own messages go nowhere: what matters of them comes back as errors.
inline void silence() {
  static const int removed = Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  static_cast<void>(removed);
}

/// What `body` returns, or an error with `code` in place of any exception.
template <class Body>
auto guarded(const ErrorCode& code, const std::string& what, Body body) -> decltype(body()) {
  try {
    silence();
    return body();
  } catch (const Standard_Failure& failure) {
    return Error{code, what + ": the geometry kernel failed (" + describe(failure) + ")"};
  } catch (const std::exception& failure) {
    return Error{code, what + ": " + failure.what()};
  }
}

/// Passes the library's progress to a context and the context's cancellation to the library. `low` and `high` are the
/// fractions of the stage that its work covers.
class ContextIndicator : public Message_ProgressIndicator {
 public:
  ContextIndicator(const Context& context, std::string stage, double low = 0, double high = 1)
      : context_(context), stage_(std::move(stage)), low_(low), high_(high) {}

 protected:
  Standard_Boolean UserBreak() override { return context_.cancelled(); }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {
    if (!context_.progress) return;
    const double fraction = low_ + (high_ - low_) * GetPosition();
    if (fraction < shown_ + 0.01) return;
    shown_ = fraction;
    context_.progress(fraction, stage_);
  }

 private:
  const Context& context_;
  std::string stage_;
  double low_, high_, shown_ = -1;
};

}  // namespace aresta
