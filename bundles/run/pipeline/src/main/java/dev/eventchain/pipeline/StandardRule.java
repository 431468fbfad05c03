package dev.eventchain.pipeline;

import dev.eventchain.check.Constraints;
import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.EventChainMetamodel;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What there is to say about a constraint that holds for all event chains. */
public final class StandardRule {

  private StandardRule() {}

  /** The qualified names of all of them, in the order of the document. */
  public static List<String> names() {
    return rules(EventChainMetamodel.constraints()).constraintNames();
  }

  /** A page in Markdown about the constraint of this qualified name, if there is one. */
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

  /** The constraint as it is written, with the comments right above it. */
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
