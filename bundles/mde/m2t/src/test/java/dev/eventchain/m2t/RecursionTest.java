package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Recursive templates and queries, up to the limit of memory. */
class RecursionTest {

  private static final Duration LONGEST = Duration.ofMinutes(10);

  /** Generation of a module for a model. */
  private interface Generator {
    GenerationResult generate(
        TemplateModule module, List<EPackage> model, GenerationContext context);
  }

  private static GenerationResult generate(String call, String callable) {
    return generate(call, callable, TemplateModule::generate);
  }

  private static GenerationResult generate(String call, String callable, Generator generator) {
    String text =
        "[module t('http://www.eclipse.org/emf/2002/Ecore')]\n"
            + "[template public main(p : EPackage)]\n[comment @main /]\n[file ('out.txt', false)]\n"
            + call
            + "\n[/file]\n[/template]\n"
            + callable;
    TemplateModule module =
        TemplateModule.compile(
            SourceText.of("t.mtl", text),
            name -> Optional.empty(),
            List.of(EcorePackage.eINSTANCE),
            Optional.of(CaseServices.class.getClassLoader()));
    EPackage model = EcoreFactory.eINSTANCE.createEPackage();
    model.setName("p");
    GenerationContext context = GenerationContext.of(each -> SourceLocation.NONE);
    return assertTimeoutPreemptively(
        LONGEST, () -> generator.generate(module, List.of(model), context));
  }

  private static String text(GenerationResult result) {
    assertEquals(List.of(), result.diagnostics());
    return new String(result.files().get("out.txt"), UTF_8);
  }

  @Test
  void templatesCallEachOtherTwentyThousandDeep() {
    String template =
        "[template public t(n : Integer)][if (n > 0)]x[t(n - 1)/][else].[/if][/template]\n";
    assertEquals("x".repeat(20_000) + ".\n", text(generate("[t(20000)/]", template)));
  }

  @Test
  void queriesCallEachOtherTwentyThousandDeep() {
    String query =
        "[query public q(n : Integer) : Integer = if n <= 0 then 0 else 1 + q(n - 1) endif/]\n";
    assertEquals("20000\n", text(generate("[q(20000)/]", query)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "[template public r(n : Integer)][r(n + 1)/][/template]",
        "[template public r(n : Integer)]x\n  [r(n + 1)/]\n[/template]",
        "[template public r(n : Integer) ? (r(n + 1) = '')]x[/template]",
        "[template public r(n : Integer) post (trim())][r(n + 1)/][/template]",
        "[query public r(n : Integer) : Integer = 1 + r(n + 1)/]",
        "[query public r(n : Integer) : Integer = Sequence{n}->collect(i | r(i + 1))->sum()/]",
        "[template public r(n : Integer)][for (i | Sequence{1, 2})][r(n + i)/][/for][/template]"
      })
  void whatHasNoEndIsStoppedByAFindingThatNamesIt(String callable) {
    assertStopped(generate("[r(0)/]", callable + "\n", ShallowStack::generate).diagnostics());
  }

  @Test
  void whatHasNoEndIsStoppedOnTheDeepestStack() {
    String query = "[query public r(n : Integer) : Integer = 1 + r(n + 1)/]\n";
    assertStopped(generate("[r(0)/]", query).diagnostics());
  }

  private static void assertStopped(List<Diagnostic> found) {
    assertEquals(1, found.size(), found.toString());
    assertEquals("m2t.recursion", found.get(0).id());
    assertTrue(found.get(0).message().contains("'r' recurses endlessly"), found.toString());
    assertTrue(found.get(0).hint().contains("'r' called at t.mtl:"), found.toString());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "'' | r(s : String) : String = r(s.concat('0123456789'))",
        "Sequence{1} | r(s : Sequence(Integer)) : Integer = r(s->append(1))"
      })
  void argumentsThatGrowWithoutEndAreStopped(String first, String signature) {
    String query = "[query public " + signature + "/]\n";
    List<Diagnostic> found = generate("[r(" + first + ")/]", query).diagnostics();
    assertEquals(List.of("m2t.recursion"), found.stream().map(Diagnostic::id).toList());
  }
}
