package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

/** Tests that validation finds exactly the violations planted in random models. */
class PlantedViolationsTest {

  /** Checks two models per try: usually 2,000 in all, 40,000 in the profile {@code thorough}. */
  @Property
  void everyPlantedViolationIsFoundAndNothingElse(@ForAll long seed) {
    check(seed);
    check(~seed);
  }

  private static void check(long seed) {
    PlantedViolations planted = PlantedViolations.of(seed);
    OclRules rules =
        OclRules.parse(
            List.of(SourceText.of("planted.ocl", planted.document())),
            List.of(planted.metamodel()));
    assertEquals(List.of(), rules.diagnostics(), planted.document());
    assertEquals(planted.expected(), found(rules, planted), planted.document());
  }

  private static Set<String> found(OclRules rules, PlantedViolations planted) {
    List<Diagnostic> diagnostics =
        OclValidator.of(rules)
            .withThreads(1)
            .validate(
                List.of(planted.root()),
                element ->
                    SourceLocation.of("model")
                        .withElement(
                            String.valueOf(
                                element.eGet(element.eClass().getEStructuralFeature("number")))))
            .diagnostics();
    Set<String> found = new TreeSet<>();
    for (Diagnostic each : diagnostics) {
      boolean violated = each.id().equals("ocl.violated");
      found.add((violated ? each.rule() : each.toString()) + " " + each.location().element());
    }
    return found;
  }
}
