package dev.eventchain.benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.constraints.OclRules;
import dev.eventchain.constraints.OclValidator;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.EventChain;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.junit.jupiter.api.Test;

/** Tests that the compared benchmarks find the same faults. */
class SameFindingsTest {

  private static final int NODES = 1_000;

  private final EventChain faulty = ChainModels.faulty(NODES);

  @Test
  void thePapersTwoConstraints() {
    List<String> byHand = sorted(PaperRules.check(faulty));
    assertEquals(byHand, found("paper.ocl", faulty));
    assertEquals(byHand, sorted(PaperRules.checkNodes(faulty)));
    assertTrue(byHand.size() > 20, byHand.toString());
    assertEquals(List.of(), found("paper.ocl", ChainModels.sound(NODES)));
  }

  @Test
  void twentyConstraints() {
    List<String> byHand = sorted(TwentyRules.check(faulty));
    assertEquals(byHand, found("twenty.ocl", faulty));
    assertEquals(List.of(), found("twenty.ocl", ChainModels.sound(NODES)));
    assertEquals(List.of(), sorted(TwentyRules.check(ChainModels.sound(NODES))));
  }

  /** A rule without violations would compare little; no chain can contain a node of another one. */
  @Test
  void eachOfTheTwentyIsBroken() {
    Set<String> broken =
        TwentyRules.check(faulty).stream()
            .map(Violation::rule)
            .collect(Collectors.toCollection(TreeSet::new));
    Set<String> rules =
        RuleFiles.ocl("twenty.ocl").constraintNames().stream()
            .map(name -> name.substring(name.indexOf("::") + 2))
            .collect(Collectors.toCollection(TreeSet::new));
    assertEquals(20, rules.size());
    rules.removeAll(broken);
    assertEquals(Set.of("NodesAreHere"), rules);
  }

  private static List<String> sorted(List<Violation> violations) {
    return violations.stream()
        .map(v -> v.rule() + " " + EcoreUtil.getURI(v.element()).fragment())
        .sorted()
        .toList();
  }

  private static List<String> found(String file, EventChain chain) {
    OclRules rules = RuleFiles.ocl(file);
    Function<EObject, SourceLocation> locator =
        element -> SourceLocation.NONE.withElement(EcoreUtil.getURI(element).fragment());
    return OclValidator.validate(rules, List.of(chain), locator).diagnostics().stream()
        .map(SameFindingsTest::words)
        .sorted()
        .toList();
  }

  private static String words(Diagnostic found) {
    assertEquals("ocl.violated", found.id(), found.toString());
    String rule = found.rule().substring(found.rule().indexOf("::") + 2);
    return rule + " " + found.location().element();
  }
}
