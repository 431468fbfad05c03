package dev.eventchain.contracts;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.BiFunction;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/** Checks and findings so far. */
final class Findings {

  private final BiFunction<EObject, EStructuralFeature, SourceLocation> locator;
  private final Map<ContractRule, Long> checks = new EnumMap<>(ContractRule.class);
  private final SortedSet<Diagnostic> found = new TreeSet<>();

  Findings(BiFunction<EObject, EStructuralFeature, SourceLocation> locator) {
    this.locator = locator;
  }

  /**
   * Returns the location of a feature of an element. Locations are looked up for findings only,
   * because most elements have none.
   */
  SourceLocation at(EObject element, EStructuralFeature feature) {
    return locator.apply(element, feature);
  }

  void checked(ContractRule rule) {
    checks.merge(rule, 1L, Long::sum);
  }

  void error(
      ContractRule rule,
      SourceLocation place,
      String message,
      String hint,
      SourceLocation... related) {
    add(Severity.ERROR, rule, place, message, hint, related);
  }

  void warning(
      ContractRule rule,
      SourceLocation place,
      String message,
      String hint,
      SourceLocation... related) {
    add(Severity.WARNING, rule, place, message, hint, related);
  }

  void info(
      ContractRule rule,
      SourceLocation place,
      String message,
      String hint,
      SourceLocation... related) {
    add(Severity.INFO, rule, place, message, hint, related);
  }

  /** Adds a finding of a severity that depends on what it is about. */
  void add(
      Severity severity,
      ContractRule rule,
      SourceLocation place,
      String message,
      String hint,
      SourceLocation... related) {
    add(
        new Diagnostic(rule.rule(), severity, message, place, hint, "", List.of())
            .withRelated(related));
  }

  void add(Diagnostic finding) {
    found.add(finding);
  }

  /** Adds findings of other checks about elements that are used here. */
  void addAll(Collection<Diagnostic> others) {
    found.addAll(others);
  }

  AnalysisResult result() {
    List<Coverage.Check> counted = new ArrayList<>();
    for (ContractRule rule : ContractRule.values()) {
      counted.add(
          new Coverage.Check(
              Coverage.Kind.CONTRACT,
              rule.id(),
              "",
              rule.rule().severity(),
              SourceLocation.NONE,
              "",
              checks.getOrDefault(rule, 0L)));
    }
    return new AnalysisResult(List.copyOf(found), counted);
  }
}
