package dev.eventchain.constraints.document;

import dev.eventchain.diagnostics.SourceRange;
import java.util.List;

/**
 * The context of an operation or a feature, and an expression that computes it.
 *
 * @param owner the class
 * @param name of the operation or feature
 * @param parameters the names of an operation's parameters; {@code null} for a feature
 * @param text the expression; {@code null} if there is none yet
 */
public record MemberContext(
    RuleDocument.Path packagePath,
    RuleDocument.Path owner,
    String name,
    List<String> parameters,
    SourceRange text) {

  public MemberContext with(SourceRange expression) {
    return new MemberContext(packagePath, owner, name, parameters, expression);
  }
}
