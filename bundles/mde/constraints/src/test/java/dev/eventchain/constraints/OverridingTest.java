package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;

/** Tests definitions of a class that override those of its superclasses. */
class OverridingTest {

  private static final String DEFINITIONS =
      """
      context AudioBook
        def: kind : String = 'audio'
        def: name(times : Integer) : String = 'recording'
      context Book
        def: kind : String = 'book'
        def: name(n : Integer) : String = 'volume'
      """;

  private final TestModels models = new TestModels("library");
  private final EPackage metamodel = models.metamodel();
  private final EObject library = models.load("library.xmi");

  private OclRules rules(String text) {
    return OclRules.parse(List.of(SourceText.of("r.ocl", text)), List.of(metamodel));
  }

  private List<String> found(OclRules rules) {
    return OclValidator.validate(rules, List.of(library), each -> SourceLocation.of("m"))
        .diagnostics()
        .stream()
        .map(Diagnostic::toString)
        .toList();
  }

  @Test
  void propertyOfTheSubclassIsTheOneThatIsRead() {
    OclRules rules =
        rules(
            DEFINITIONS
                + """
                context Book inv Kind: kind = if oclIsTypeOf(AudioBook) then 'audio' else 'book' endif
                context AudioBook inv Audio: kind = 'audio' and self.name(1) = 'recording'
                context Library inv All: books.kind->asSet() = Set{'audio', 'book'}
                """);
    assertEquals(List.of(), found(rules));
  }

  @Test
  void propertyThatIsStoredCannotBeOverridden() {
    List<Diagnostic> said =
        rules("context AudioBook def: title : String = 'x' inv A: true").diagnostics();
    assertEquals(List.of("ocl.duplicate"), said.stream().map(Diagnostic::id).toList());
  }

  @Test
  void propertyIsDefinedOnceInAClass() {
    String twice = DEFINITIONS + "context Book def: kind : String = 'x'\ncontext Book inv A: true";
    assertTrue(rules(twice).diagnostics().get(0).message().contains("twice"));
    String other = DEFINITIONS + "context Book def: kind : Integer = 1\ncontext Book inv A: true";
    assertEquals("ocl.duplicate", rules(other).diagnostics().get(0).id());
  }
}
