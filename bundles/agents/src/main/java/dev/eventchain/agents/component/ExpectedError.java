package dev.eventchain.agents.component;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.sandbox.ComponentRules;

/**
 * An error that the last call of a test has to raise.
 *
 * @param kind the name of its class
 * @param message a part of its message; empty for any
 */
record ExpectedError(String kind, String message) {

  private static final String NAME = "[A-Za-z_][A-Za-z0-9_]*";

  /** Reads an expected error; a kind that no class can have is a finding of the reader. */
  static ExpectedError read(ObjectReader given) {
    String kind = given.requiredText("kind");
    if (!kind.isEmpty() && !kind.matches(NAME)) {
      given.find(
          ComponentTestsReader.FORMAT,
          "'" + kind + "' is no name of a class, such as ValueError.",
          given.at("kind"));
    }
    ExpectedError error = new ExpectedError(kind, given.text("message").orElse(""));
    given.refuseOthers();
    return error;
  }

  /** Returns whether a problem is this error in a call of a test, and not one of its creation. */
  boolean accepts(Diagnostic problem, String test) {
    String raised = "execute() in the call '" + test + "' raised " + kind;
    if (!problem.is(ComponentRules.RAISED) || !problem.message().startsWith(raised)) {
      return false;
    }
    String rest = problem.message().substring(raised.length());
    return (rest.equals(".") || rest.startsWith(": ")) && rest.contains(message);
  }

  String words() {
    return message.isEmpty() ? kind : kind + " with '" + message + "'";
  }
}
