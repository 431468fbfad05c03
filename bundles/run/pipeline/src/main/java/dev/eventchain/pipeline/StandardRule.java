package dev.eventchain.pipeline;

import dev.eventchain.check.Constraints;
import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.EventChainMetamodel;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Explanation of a standard constraint, which holds for all event chains. */
public final class StandardRule {

  private StandardRule() {}

  /** Returns the qualified names of all standard constraints, in the order of the document. */
  public static List<String> names() {
    return rules(EventChainMetamodel.constraints()).constraintNames();
  }

  /** Returns the Markdown page about a constraint by its qualified name, if it exists. */
  public static Optional<String> page(String name) {
    SourceText document = EventChainMetamodel.constraints();
    return rules(document).constraint(name).map(constraint -> page(constraint, document));
  }

  private static OclRules rules(SourceText document) {
    return Constraints.parse(List.of(document));
  }

  private static String page(OclConstraint constraint, SourceText document) {
    String hint = constraint.hint().isEmpty() ? "" : constraint.hint() + "\n\n";
    return "# "
        + constraint.qualifiedName()
        + "\n\n"
        + "A standard constraint of event chains; a violation is "
        + switch (constraint.severity()) {
          case ERROR -> "an error";
          case WARNING -> "a warning";
          case INFO -> "information";
        }
        + ".\n\n"
        + hint
        + source(constraint, document)
        + "\n"
        + constraint.location()
        + "\n";
  }

  /** Returns the source text of the constraint with the preceding comments. */
  private static String source(OclConstraint constraint, SourceText document) {
    List<String> lines = document.text().lines().toList();
    int first = constraint.location().line() - 1;
    int from = first;
    while (from > 0 && lines.get(from - 1).strip().startsWith("--")) {
      from--;
    }
    int to = first + 1;
    while (to < lines.size() && !lines.get(to).matches("\\s*(--.*|(inv|def|context)\\b.*)?")) {
      to++;
    }
    List<String> source = new ArrayList<>();
    source.add("    context " + constraint.context().getName());
    lines.subList(from, to).forEach(line -> source.add("    " + line.stripTrailing()));
    return String.join("\n", source) + "\n";
  }
}
