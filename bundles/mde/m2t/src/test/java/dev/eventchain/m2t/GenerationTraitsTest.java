package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationContext.Trait;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.m2t.generation.GenerationTrace.Segment;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;
import org.junit.jupiter.api.Test;

/** Generations with traits. */
class GenerationTraitsTest {
  private static final String HEAD =
      """
      [module t('http://www.eclipse.org/emf/2002/Ecore')]
      [template public main(p : EPackage)]
      [comment @main /]
      """;

  private static GenerationResult generate(String body, Trait... traits) {
    TemplateModule module =
        TemplateModule.compile(
            SourceText.of("t.mtl", HEAD + body + "\n[/template]\n"),
            name -> Optional.empty(),
            List.of(EcorePackage.eINSTANCE));
    EPackage model = EcoreFactory.eINSTANCE.createEPackage();
    GenerationContext context =
        GenerationContext.of(each -> SourceLocation.of("m").withElement("/"));
    return module.generate(List.of(model), context.with(Set.of(traits)));
  }

  private static String findings(GenerationResult result) {
    return result.diagnostics().stream()
        .map(
            each ->
                each.location() + " " + each.severity() + " " + each.id() + " " + each.message())
        .collect(Collectors.joining("\n"));
  }

  @Test
  void anUndefinedValueIsAnErrorOrLenientlyAWarning() {
    String body = "[file ('x')]a[p.eClassifiers->at(7).name/]b[/file]";
    GenerationResult result = generate(body);
    assertEquals("ainvalidb", new String(result.files().get("x"), UTF_8));
    assertTrue(result.isWhole());
    assertTrue(findings(result).startsWith("t.mtl:4:31 error m2t.undefined"), findings(result));
    String lenient = findings(generate(body, Trait.LENIENT));
    assertTrue(lenient.startsWith("t.mtl:4:31 warning m2t.undefined"), lenient);
  }

  @Test
  void aFileThatIsOverwrittenIsAnErrorOrLenientlyTheLast() {
    String body = "[file ('x')]1\n2\n[/file]\n[file ('./x')]3[/file]";
    String where = "x' was already written in this run, by the block at t.mtl:4:8 for /.";
    GenerationResult strict = generate(body);
    assertFalse(strict.isWhole());
    assertEquals("t.mtl:7:8 error m2t.file.duplicate The file '" + where, findings(strict));
    GenerationResult lenient = generate(body, Trait.LENIENT, Trait.TRACED);
    assertTrue(lenient.isWhole());
    assertEquals("3", new String(lenient.files().get("x"), UTF_8));
    assertEquals(
        "t.mtl:7:8 warning m2t.file.duplicate The file '" + where + " That output is lost.",
        findings(lenient));
    List<Segment> traced = lenient.trace().files().get("x");
    assertEquals(1, traced.get(traced.size() - 1).lastLine(), "lines that are lost");
  }

  @Test
  void aFileInsideItselfIsAnErrorLeniently() {
    GenerationResult result = generate("[file ('x')]1[file ('x')]2[/file][/file]", Trait.LENIENT);
    assertFalse(result.isWhole());
    assertEquals("1", new String(result.files().get("x"), UTF_8));
  }

  @Test
  void withoutAFolderFilesAreErrorsAndBlocksInsideOfThemPrint() {
    GenerationResult result =
        generate("[file ('x')]a[file ('stdout')]b[/file][/file]", Trait.PRINTED_ONLY);
    assertEquals(Set.of(), result.files().keySet());
    assertEquals("b", result.printedText());
    assertEquals(
        "t.mtl:4:8 error m2t.file.no-folder The file 'x' is not written: there is no folder.",
        findings(result));
  }
}
