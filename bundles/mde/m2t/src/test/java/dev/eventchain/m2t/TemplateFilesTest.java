package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.generation.GenerationResult;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Malformed and unusually large template files. */
class TemplateFilesTest {

  private static final String HEAD =
      """
      [module t('http://www.eclipse.org/emf/2002/Ecore')]
      [template public main(p : EPackage)]
      [comment @main /]
      [file ('out.txt')]
      """;
  private static final String FOOT = "\n[/file]\n[/template]\n";

  @TempDir Path temporary;

  private TemplateModule compile(String text, Charset charset) throws IOException {
    Path file = temporary.resolve("t.mtl");
    Files.write(file, text.getBytes(charset));
    return TemplateModule.compile(file, List.of(EcorePackage.eINSTANCE));
  }

  private List<String> problems(String text, Charset charset) {
    DiagnosticException e = assertThrows(DiagnosticException.class, () -> compile(text, charset));
    return e.diagnostics().stream().map(TemplateFilesTest::shown).toList();
  }

  private static String shown(Diagnostic diagnostic) {
    return diagnostic.location().line() + ":" + diagnostic.id() + ": " + diagnostic.message();
  }

  private static byte[] generate(TemplateModule module) {
    EPackage model = EcoreFactory.eINSTANCE.createEPackage();
    model.setName("p");
    GenerationResult result = module.generate(List.of(model), each -> SourceLocation.NONE);
    assertEquals(List.of(), result.diagnostics());
    return result.files().get("out.txt");
  }

  @Test
  void aFileIsReadInTheEncodingThatItsFirstTagSays() throws IOException {
    String text = "[comment encoding = ISO-8859-1 /]\n" + HEAD + "gr\u00fcn" + FOOT;
    assertArrayEquals("gr\u00fcn\n".getBytes(UTF_8), generate(compile(text, ISO_8859_1)));
  }

  @Test
  void anImportedFileIsReadInItsOwnEncoding() throws IOException {
    String module =
        """
        [comment encoding = ISO-8859-1 /]
        [module o('http://www.eclipse.org/emf/2002/Ecore')]
        [query public green(p : EPackage) : String = p.name.concat('gr\u00fcn') /]
        """;
    Files.write(temporary.resolve("o.mtl"), module.getBytes(ISO_8859_1));
    String head = HEAD.replace("[template", "[import o]\n[template");
    assertArrayEquals(
        "pgr\u00fcn\n".getBytes(UTF_8), generate(compile(head + "[p.green()/]" + FOOT, UTF_8)));
  }

  @Test
  void aModuleThatIsReachedByTwoNamesIsLoadedOnce() throws IOException {
    Path here = Path.of("").toAbsolutePath().relativize(temporary.toAbsolutePath());
    String wrong = "[module a::lib('http://www.eclipse.org/emf/2002/Ecore')]\n[wrong]\n";
    String main = HEAD.replace("[template", "[import lib]\n[import a::lib]\n[template") + FOOT;
    Files.createDirectory(temporary.resolve("a"));
    Files.writeString(temporary.resolve("a/lib.mtl"), wrong);
    Path file = Files.writeString(here.resolve("a/main.mtl"), main);
    List<EPackage> packages = List.of(EcorePackage.eINSTANCE);
    for (List<Path> roots : List.of(List.<Path>of(), List.of(temporary))) {
      DiagnosticException e =
          assertThrows(
              DiagnosticException.class,
              () -> TemplateModule.compile(file, roots, packages, Optional.empty()));
      assertEquals(1, e.diagnostics().size(), e.diagnostics().toString());
    }
  }

  @Test
  void anEncodingThatDoesNotExistIsNamed() {
    assertEquals(
        List.of("0:m2t.charset: There is no charset 'EBCDIC-9'."),
        problems("[comment encoding = EBCDIC-9 /]\n" + HEAD + "x" + FOOT, UTF_8));
  }

  @Test
  void aFileThatIsNotInTheEncodingItSaysIsNamed() {
    assertEquals(
        List.of("0:file.encoding: The file is not US-ASCII text."),
        problems("[comment encoding = US-ASCII /]\n" + HEAD + "gr\u00fcn" + FOOT, UTF_8));
  }

  @Test
  void aFileThatIsNotUtf8IsNamedWithItsLine() {
    assertEquals(
        List.of("5:file.encoding: The file is not UTF-8 text."),
        problems(HEAD + "gr\u00fcn" + FOOT, ISO_8859_1));
  }

  @Test
  void aNulCharacterIsAnError() {
    assertEquals(
        List.of("5:file.encoding: The file contains a NUL character, which text never does."),
        problems(HEAD + "a\0b" + FOOT, UTF_8));
  }

  @Test
  void javaServicesAreRefusedUnlessSomeAreGiven() {
    assertEquals(
        List.of("5:m2t.service: The template calls a Java service, and no services were given."),
        problems(HEAD + "[invoke('a.B', 'c()', Sequence{})/]" + FOOT, UTF_8));
  }

  @Test
  void blocksNestedTenThousandDeepAreOneError() {
    String text = HEAD + "[if (true)]".repeat(10_000) + "x" + "[/if]".repeat(10_000) + FOOT;
    assertEquals(
        List.of("5:m2t.nesting: Blocks are nested more than 200 deep."), problems(text, UTF_8));
  }

  @Test
  void parenthesesNestedTenThousandDeepAreGenerated() throws IOException {
    String text = HEAD + "[" + "(".repeat(10_000) + "1" + ")".repeat(10_000) + "/]" + FOOT;
    assertArrayEquals("1\n".getBytes(UTF_8), generate(compile(text, UTF_8)));
  }

  @Test
  void callsNestedTenThousandDeepAreOneError() {
    String text =
        HEAD + "[" + "'a'.concat(".repeat(10_000) + "'a'" + ")".repeat(10_000) + "/]" + FOOT;
    assertEquals(
        List.of("5:ocl.syntax: The expression is nested too deeply."), problems(text, UTF_8));
  }

  @Test
  void aTemplateOfTenMegabytesIsGenerated() throws IOException {
    String line = "0123456789 [p.name/] 0123456789\n";
    String text = "[comment nothing /]0123456789\n".repeat(100_000) + line.repeat(1000);
    String filled = text + "x".repeat(10 << 20);
    byte[] out = generate(compile(HEAD + filled + FOOT, UTF_8));
    assertTrue(out.length > 10 << 20);
  }

  @Test
  void tenMegabytesOfUnclosedTagsAreAThousandErrors() {
    List<String> problems = problems(HEAD + "[".repeat(10 << 20) + FOOT, UTF_8);
    assertEquals("5:m2t.syntax: This tag is not closed.", problems.get(0));
    assertEquals(
        "5:m2t.syntax: There are more than 1000 problems; the others are not listed.",
        problems.get(problems.size() - 1));
    assertEquals(1001, problems.size());
  }
}
