package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.m2t.generation.GenerationTrace.Origin;
import dev.eventchain.m2t.generation.GenerationTrace.Segment;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;
import org.junit.jupiter.api.Test;

/** Template lines are named by their numbers: the header is line 1, the file block line 4. */
class GenerationTraceTest {

  private static final String HEADER =
      """
      [module t('http://www.eclipse.org/emf/2002/Ecore')]
      [template public main(p : EPackage)]
      [comment @main /]
      """;

  private static EPackage model() {
    EPackage model = EcoreFactory.eINSTANCE.createEPackage();
    model.setName("model");
    for (String name : List.of("A", "B")) {
      EClass each = EcoreFactory.eINSTANCE.createEClass();
      each.setName(name);
      model.getEClassifiers().add(each);
    }
    return model;
  }

  private static GenerationResult generate(String rest, Map<String, String> earlier) {
    TemplateModule module =
        TemplateModule.compile(
            SourceText.of("t.mtl", HEADER + rest),
            name -> Optional.empty(),
            List.of(EcorePackage.eINSTANCE));
    GenerationContext context =
        GenerationContext.of(
                e -> SourceLocation.of("m.xmi").withElement(((ENamedElement) e).getName()))
            .withEarlier(
                name -> Optional.ofNullable(earlier.get(name)).map(t -> t.getBytes(UTF_8)));
    GenerationResult plain = module.generate(List.of(model()), context);
    GenerationResult traced = module.generate(List.of(model()), context.withTrace());
    assertEquals(Map.of(), plain.trace().files());
    assertEquals(text(plain), text(traced));
    assertEquals(plain.diagnostics(), traced.diagnostics());
    return traced;
  }

  private static String text(GenerationResult result) {
    return new String(result.files().get("o"), UTF_8);
  }

  /** Asserts the text, and the lines and origins of each segment. */
  private static void assertTrace(String text, String lines, GenerationResult result) {
    assertEquals(List.of(), result.diagnostics());
    assertEquals(text, text(result));
    assertEquals(
        lines,
        result.trace().files().get("o").stream()
            .map(GenerationTraceTest::words)
            .collect(Collectors.joining("; ")));
  }

  private static String words(Segment segment) {
    String origins =
        segment.origins().stream().map(GenerationTraceTest::words).collect(Collectors.joining(" "));
    return segment.firstLine() + "-" + segment.lastLine() + ": " + origins;
  }

  private static String words(Origin origin) {
    assertEquals("t.mtl", origin.template().file());
    assertEquals("m.xmi", origin.element().file());
    return origin.template().line() + origin.element().element();
  }

  @Test
  void textComesFromItsLineAndLoopsFromTheirElements() {
    String template =
        """
        [file ('o')]
        one
        [for (c : EClassifier | p.eClassifiers)]
        two [c.name/]
          [c.name/]
        [/for]

        end
        [/file]
        [/template]
        """;
    assertTrace(
        "one\ntwo A\n  A\ntwo B\n  B\n\nend\n",
        "1-1: 5model; 2-2: 7A; 3-3: 8A; 4-4: 7B; 5-5: 8B; 6-6: 10model; 7-7: 11model",
        generate(template, Map.of()));
  }

  @Test
  void aCalledTemplatesLinesCountAndIndentationHasNoOrigin() {
    String template =
        """
        [file ('o')]
        [for (c : EClassifier | p.eClassifiers)]
          [c.block()/]
        [/for]
        [/file]
        [/template]
        [template public block(c : EClassifier)]
        [c.name/] {
         \s
          in
          }
        [/template]
        """;
    assertTrace(
        "  A {\n    \n    in\n    }\n  B {\n    \n    in\n    }\n",
        "1-1: 6A 11A; 2-2: 12A; 3-3: 13A; 4-4: 6A 14A; 5-5: 6B 11B; 6-6: 12B; 7-7: 13B;"
            + " 8-8: 6B 14B",
        generate(template, Map.of()));
  }

  @Test
  void separatorsComeFromTheTagAndCallsForEachElementFromTheTemplate() {
    String template =
        """
        [file ('o')][p.eClassifiers.line() before('<\\n') separator('\\n--\\n') after('\\n>\\n')/][/file]
        [/template]
        [template public line(c : EClassifier)]
        [c.name/]
        [/template]
        """;
    assertTrace(
        "<\nA\n--\nB\n>\n",
        "1-1: 4model; 2-2: 4model 7A; 3-3: 4model; 4-4: 4model 7B; 5-5: 4model",
        generate(template, Map.of()));
  }

  @Test
  void whatPostCutsOutKeepsItsOrigins() {
    String template =
        """
        [file ('o')][p.letters()/]
        [/file]
        [/template]
        [template public letters(p : EPackage) post (trim())]


        a
        b

        [/template]
        """;
    assertTrace("a\nb\n", "1-1: 10model; 2-2: 4model 11model", generate(template, Map.of()));
  }

  @Test
  void whatPostChangesComesFromPost() {
    String template =
        """
        [file ('o')][p.letters()/]
        [/file]
        [/template]
        [template public letters(p : EPackage) post (toUpper())]
        a
        b
        [/template]
        """;
    assertTrace("A\nB\n", "1-1: 7model; 2-2: 4model 7model", generate(template, Map.of()));
  }

  @Test
  void whatAnExpressionWorksOnComesFromTheTagAndElement() {
    String template =
        """
        [file ('o')][p.letters().concat('!')/]
        [/file]
        [/template]
        [template public letters(p : EPackage)]
        A
        B
        [/template]
        """;
    assertTrace("A\nB!\n", "1-2: 4model", generate(template, Map.of()));
  }

  @Test
  void keptAreasComeFromNobody() {
    String earlier = "# Start of user code x\nmine\nmine too\n# End of user code\n";
    String template =
        """
        [file ('o')]
        # [protected ('x')]
        nothing
        # [/protected]
        end
        [/file]
        [/template]
        """;
    assertTrace(
        "# Start of user code x\nmine\nmine too\n# End of user code\nend\n",
        "1-1: 5model; 4-4: 5model 7model; 5-5: 8model",
        generate(template, Map.of("o", earlier)));
  }

  @Test
  void keptAreasOfAllBlocksOfAFileComeFromNobody() {
    String earlier =
        """
        <!-- Start of user code x -->
        mine
        <!-- End of user code -->
        # Start of user code y
        mine
        mine too
        # End of user code
        """;
    String template =
        """
        [file ('o', true)]
        <!-- [protected ('x')] -->
        nothing
        <!-- [/protected] -->
        [/file]
        [file ('o', true)]
        [let area : String = p.area()]
        [area/]
        [/let]
        [/file]
        [/template]
        [template public area(p : EPackage)]
        # [protected ('y')]
        nothing
        # [/protected]
        [/template]
        """;
    assertTrace(
        earlier.replace("# Start", "\n# Start"),
        "1-1: 5model; 3-3: 5model 7model; 5-5: 11model; 8-8: 11model",
        generate(template, Map.of("o", earlier)));
  }

  @Test
  void theBreakAheadOfAppendedTextComesFromNobody() {
    String template =
        """
        [file ('o')]
        a
        b[/file]
        [file ('o', true)]
         c
        d
        [/file]
        [/template]
        """;
    assertTrace(
        "a\nb\n c\nd\n",
        "1-1: 5model; 2-2: 6model; 3-3: 8model; 4-4: 9model",
        generate(template, Map.of()));
  }
}
