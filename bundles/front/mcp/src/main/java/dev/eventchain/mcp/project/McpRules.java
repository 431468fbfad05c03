package dev.eventchain.mcp.project;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;

/** Rules of what the server refuses to do for a client. */
public final class McpRules {

  /** Arguments of a tool that are not as its schema says. */
  public static final Rule ARGUMENT = Rule.error("mcp.argument");

  /** A file that cannot be read, or is too large to be sent. */
  public static final Rule FILE = Rule.error("mcp.file");

  /** A path, or a link, that leads out of the server's folder. */
  public static final Rule OUTSIDE = Rule.error("mcp.outside");

  /** Results that a project does not have. */
  public static final Rule RESULTS = Rule.error("mcp.results");

  /** A change that cannot be made as it was described. */
  public static final Rule CHANGE = Rule.error("mcp.change");

  /** A change of a file in which a person decides. */
  public static final Rule PROTECTED = Rule.error("mcp.protected");

  /** More calls at a time than are worked on. */
  public static final Rule BUSY = Rule.error("mcp.busy");

  private McpRules() {}

  /** Returns a refusal about a file, or about none if its name is empty. */
  public static DiagnosticException refusal(Rule rule, String file, String message, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(rule, message, SourceLocation.of(file)).withHint(hint));
  }
}
