package dev.eventchain.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.check.ReferenceFolders;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.files.WrittenFiles;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests generation from several models and with Java services. */
class AnyModelTest {

  private static final String ECORE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="shop" nsURI="http://example.org/shop" nsPrefix="shop">
        <eClassifiers xsi:type="ecore:EClass" name="Shop">
          <eStructuralFeatures xsi:type="ecore:EAttribute" name="name" eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EString"/>
          <eStructuralFeatures xsi:type="ecore:EReference" name="owner" eType="#//Person"/>
        </eClassifiers>
        <eClassifiers xsi:type="ecore:EClass" name="Person">
          <eStructuralFeatures xsi:type="ecore:EAttribute" name="name" eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EString"/>
        </eClassifiers>
      </ecore:EPackage>
      """;

  private static final String TEMPLATE =
      """
      [module main('http://example.org/shop')]
      [template public main(shop : Shop)]
      [comment @main /]
      [file (shop.name)]
      BODY
      [/file]
      [/template]
      """;

  private static final String SERVICE =
      """
      package demo;
      public class Words {
        public static String loud(String word) {
          return word.toUpperCase(java.util.Locale.ROOT);
        }
      }
      """;

  @TempDir Path folder;

  @BeforeEach
  void write() throws IOException {
    Files.writeString(folder.resolve("shop.ecore"), ECORE);
    Files.writeString(folder.resolve("bakery.xmi"), shop("bakery", "anna.xmi"));
    Files.writeString(folder.resolve("smithy.xmi"), shop("smithy", "bert.xmi"));
    Files.writeString(folder.resolve("anna.xmi"), person("Anna"));
    Files.writeString(folder.resolve("bert.xmi"), person("Bert"));
  }

  private static String shop(String name, String owner) {
    return """
    <?xml version="1.0" encoding="UTF-8"?>
    <shop:Shop xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:shop="http://example.org/shop" name="%s">
      <owner href="%s#/"/>
    </shop:Shop>
    """
        .formatted(name, owner);
  }

  private static String person(String name) {
    return """
    <?xml version="1.0" encoding="UTF-8"?>
    <shop:Person xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:shop="http://example.org/shop" name="%s"/>
    """
        .formatted(name);
  }

  private List<Diagnostic> generate(String body, List<Path> services, String... models)
      throws IOException {
    Path template = Files.writeString(folder.resolve("main.mtl"), TEMPLATE.replace("BODY", body));
    return write(template, services, models).diagnostics();
  }

  private WrittenFiles write(Path template, List<Path> services, String... models) {
    return AnyModel.generate(
        new ModelFiles(
            List.of(models).stream().map(folder::resolve).toList(),
            List.of(folder.resolve("shop.ecore")),
            ReferenceFolders.NONE),
        new AnyModel.Template(template, List.of(), services, List.of()),
        new AnyModel.Target(
            Optional.of(folder.resolve("out")), OnEdit.KEEP, false, Optional.empty()),
        new AnyModel.Check(false, Suppressions.NONE, Duration.ofSeconds(30)));
  }

  @Test
  void itSaysWhatBecameOfTheFiles() throws IOException {
    String text =
        "[module t('http://example.org/shop')]\n[template public t(s : Shop)]\n[comment @main/]\n";
    text += "[file (s.name, false)][s.owner.name/][/file]\n[/template]\n";
    Path template = Files.writeString(folder.resolve("t.mtl"), text);
    String where = folder.resolve("out").toString();
    assertEquals(
        "1 file in " + where + ": 1 written", write(template, List.of(), "bakery.xmi").summary());
    assertEquals(
        "2 files in " + where + ": 1 written, 1 unchanged",
        write(template, List.of(), "bakery.xmi", "smithy.xmi").summary());
    Files.writeString(folder.resolve("out/bakery"), "mine");
    assertEquals(
        "1 file in " + where + ": 1 kept", write(template, List.of(), "bakery.xmi").summary());
  }

  @ParameterizedTest
  @CsvSource({
    "x/eventchain.yaml, 0",
    "x/EVENTCHAIN.YAML, 0",
    "./eventchain.yaml, 0",
    "recordings/a/b.json, 0",
    ".git/hooks/pre-commit, 0",
    "x/.hidden, 0",
    "x/eventchain.yaml.txt, 2",
    "my-recordings/b.json, 2",
    "x.y/z, 2"
  })
  void nothingIsWrittenIfANameIsRefused(String name, int written) throws IOException {
    String body = "[file ('a.txt', false)]a[/file][file ('" + name + "', false)]b[/file]";
    Path template = Files.writeString(folder.resolve("main.mtl"), TEMPLATE.replace("BODY", body));
    WrittenFiles files =
        AnyModel.generate(
            new ModelFiles(
                List.of(folder.resolve("bakery.xmi")),
                List.of(folder.resolve("shop.ecore")),
                ReferenceFolders.NONE),
            new AnyModel.Template(template, List.of(), List.of(), List.of()),
            new AnyModel.Target(
                Optional.of(folder.resolve("out")),
                OnEdit.OVERWRITE,
                false,
                Optional.empty(),
                List.of("eventchain.yaml", "recordings", ".*")),
            new AnyModel.Check(false, Suppressions.NONE, Duration.ofSeconds(30)));
    assertEquals(
        written == 0 ? List.of("output.path.refused") : List.of(),
        files.diagnostics().stream().map(Diagnostic::id).toList());
    assertEquals(written > 0, Files.exists(folder.resolve("out/a.txt")));
  }

  @Test
  void noAreaIsSaidToBeSavedWhereNothingIsWritten() throws IOException {
    Files.createDirectories(folder.resolve("out"));
    Files.writeString(
        folder.resolve("out/bakery"), "Start of user code gone\nmine\nEnd of user code\n");
    Path template =
        Files.writeString(
            folder.resolve("main.mtl"),
            TEMPLATE.replace("BODY", "[file ('x')][/file][file ('x')][/file]"));
    WrittenFiles files = write(template, List.of(), "bakery.xmi");
    assertEquals(
        List.of("m2t.file.duplicate"), files.diagnostics().stream().map(Diagnostic::id).toList());
    assertEquals("nothing was written in " + folder.resolve("out"), files.summary());
    assertFalse(Files.exists(folder.resolve("out/bakery.lost")));
  }

  private String out(String name) throws IOException {
    return Files.readString(folder.resolve("out").resolve(name));
  }

  /** Returns a folder with the compiled service. */
  private Path classes() throws IOException {
    Path source = folder.resolve("src/demo/Words.java");
    Files.createDirectories(source.getParent());
    Files.writeString(source, SERVICE);
    Path classes = Files.createDirectories(folder.resolve("classes"));
    int failed =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, "-d", classes.toString(), source.toString());
    assertEquals(0, failed);
    return classes;
  }

  @Test
  void aModelMayReferToOtherFiles() throws IOException {
    assertEquals(List.of(), generate("[shop.owner.name/]", List.of(), "bakery.xmi"));
    assertEquals("Anna\n", out("bakery"));
  }

  @Test
  void severalModelsAreGeneratedInOneRun() throws IOException {
    String body = "[shop.owner.name/] of [Shop.allInstances()->size()/]";
    assertEquals(List.of(), generate(body, List.of(), "bakery.xmi", "smithy.xmi"));
    assertEquals("Anna of 2\n", out("bakery"));
    assertEquals("Bert of 2\n", out("smithy"));
  }

  @Test
  void servicesAreTakenFromAFolder() throws IOException {
    String body = "[invoke('demo.Words', 'loud(String)', Sequence{shop.name})/]";
    assertEquals(List.of(), generate(body, List.of(classes()), "bakery.xmi"));
    assertEquals("BAKERY\n", out("bakery"));
  }

  @Test
  void servicesAreTakenFromAJar() throws IOException {
    Path jar = folder.resolve("words.jar");
    try (OutputStream stream = Files.newOutputStream(jar);
        JarOutputStream entries = new JarOutputStream(stream)) {
      entries.putNextEntry(new JarEntry("demo/Words.class"));
      entries.write(Files.readAllBytes(classes().resolve("demo/Words.class")));
    }
    String body = "[invoke('demo.Words', 'loud(java.lang.String)', Sequence{'x'})/]";
    assertEquals(List.of(), generate(body, List.of(jar), "bakery.xmi"));
    assertEquals("X\n", out("bakery"));
  }

  @Test
  void theProgramsOwnClassesAreNoServices() throws IOException {
    String body = "[invoke('dev.eventchain.pipeline.Pipeline', 'toString()', Sequence{})/]";
    List<Diagnostic> found = generate(body, List.of(classes()), "bakery.xmi");
    assertEquals(List.of("m2t.service"), found.stream().map(Diagnostic::id).toList());
  }

  @Test
  void servicesThatAreMissingOrNoJarAreNamed() throws IOException {
    Path text = Files.writeString(folder.resolve("services.txt"), "no jar");
    assertEquals("file.unreadable", problem(text));
    assertEquals("file.missing", problem(folder.resolve("nowhere.jar")));
  }

  private String problem(Path services) {
    return assertThrows(
            DiagnosticException.class, () -> generate("x", List.of(services), "bakery.xmi"))
        .diagnostics()
        .get(0)
        .id();
  }

  private static List<String> ids(List<Diagnostic> found) {
    return found.stream().map(Diagnostic::id).toList();
  }

  /** Requires the owner of a shop and the name of a person. */
  private void demand() throws IOException {
    String demanding =
        ECORE
            .replace("name=\"owner\"", "name=\"owner\" lowerBound=\"1\"")
            .replace(
                "\"Person\">\n    <eStructuralFeatures",
                "\"Person\">\n    <eStructuralFeatures lowerBound=\"1\"");
    Files.writeString(folder.resolve("shop.ecore"), demanding);
  }

  @Test
  void nothingIsGeneratedFromAModelThatIsNoInstance() throws IOException {
    demand();
    Files.writeString(
        folder.resolve("bakery.xmi"), shop("bakery", "anna.xmi").replaceAll("<owner.*/>", ""));
    assertEquals(List.of("ecore.required"), ids(generate("x", List.of(), "bakery.xmi")));
    assertFalse(Files.exists(folder.resolve("out")));
  }
}
