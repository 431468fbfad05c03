package dev.eventchain.agents;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.DeepStack;
import dev.eventchain.ocl.OclConstraint;
import dev.eventchain.ocl.OclRules;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;

/**
 * Whether an OCL document parses, covers every design rule, and says something with each of its
 * constraints.
 */
final class ConstraintCheck {
  private static final Pattern COMMENT = Pattern.compile("(?m)^\\s*--(.*)$");

  private final List<String> ruleIds;
  private final Collection<EPackage> packages;
  private final List<EObject> model;

  /**
   * Prepares the check.
   *
   * @param ruleIds the ids of the design rules
   * @param packages the metamodel
   * @param model the roots of a model to start the search for witnesses from; it is not changed
   */
  ConstraintCheck(List<String> ruleIds, Collection<EPackage> packages, List<EObject> model) {
    this.ruleIds = List.copyOf(ruleIds);
    this.packages = packages;
    this.model = List.copyOf(model);
  }

  List<Diagnostic> check(SourceText document) {
    OclRules rules = OclRules.parse(List.of(document), packages);
    List<Diagnostic> diagnostics = new ArrayList<>(rules.diagnostics());
    if (Diagnostic.anyError(diagnostics)) {
      return diagnostics;
    }
    if (rules.constraints().isEmpty()) {
      diagnostics.add(
          Diagnostic.error(
              "agents.constraint.none", "The document holds no invariant.", document.at(0)));
    }
    diagnostics.addAll(uncovered(document));
    diagnostics.addAll(vacuous(rules.constraints()));
    return diagnostics;
  }

  private List<Diagnostic> uncovered(SourceText document) {
    StringBuilder comments = new StringBuilder();
    for (Matcher comment = COMMENT.matcher(document.text()); comment.find(); ) {
      comments.append(comment.group(1)).append('\n');
    }
    List<Diagnostic> diagnostics = new ArrayList<>();
    for (String id : ruleIds) {
      Pattern mention = Pattern.compile("(?<![\\w-])" + Pattern.quote(id) + "(?![\\w-])");
      if (!mention.matcher(comments).find()) {
        diagnostics.add(
            Diagnostic.error(
                    "agents.rule.uncovered",
                    "No constraint is marked as the one for the design rule " + id + ".",
                    document.at(0))
                .withHint("Write '-- " + id + ": ...' above its invariant."));
      }
    }
    return diagnostics;
  }

  private List<Diagnostic> vacuous(List<OclConstraint> constraints) {
    return DeepStack.call(() -> constraints.stream().flatMap(c -> objection(c).stream()).toList());
  }

  private List<Diagnostic> objection(OclConstraint constraint) {
    return ConstraintProof.objection(constraint, model)
        .map(
            objection ->
                Diagnostic.error(
                        "agents.constraint.vacuous",
                        objection
                            + ": changed values, references and contained objects of the model made"
                            + " no difference.",
                        constraint.location())
                    .withHint("Write it so that it can both hold and fail.")
                    .withRule(constraint.qualifiedName()))
        .stream()
        .toList();
  }
}
