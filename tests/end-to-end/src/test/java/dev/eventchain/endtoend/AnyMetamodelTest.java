package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.List;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests validation and generation on a metamodel unrelated to event chains. */
class AnyMetamodelTest {

  static final String ECORE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="library" nsURI="http://example.org/library" nsPrefix="library">
        <eClassifiers xsi:type="ecore:EClass" name="Book">
          <eStructuralFeatures xsi:type="ecore:EAttribute" name="title" eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EString"/>
          <eStructuralFeatures xsi:type="ecore:EAttribute" name="pages" eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EInt"/>
        </eClassifiers>
        <eClassifiers xsi:type="ecore:EClass" name="Library">
          <eStructuralFeatures xsi:type="ecore:EReference" name="books" upperBound="-1" eType="#//Book" containment="true"/>
        </eClassifiers>
      </ecore:EPackage>
      """;

  static final String MODEL =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <library:Library xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:library="http://example.org/library">
        <books title="Good" pages="100"/>
        <books title="Bad" pages="-1"/>
      </library:Library>
      """;

  private static final String TEMPLATE =
      """
      [module main('http://example.org/library')]
      [template public main(library : Library)]
      [comment @main /]
      [for (book : Book | library.books)]
      [file (book.title.toLowerCase().concat('.txt'), false, 'UTF-8')]
      [book.title/] has [book.pages/] pages.
      [/file]
      [/for]
      [/template]
      """;

  private static final String SHOP =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="shop" nsURI="http://example.org/shop" nsPrefix="shop">
        <eClassifiers xsi:type="ecore:EClass" name="Shop">
          <eStructuralFeatures xsi:type="ecore:EReference" name="offers" upperBound="-1" eType="ecore:EClass platform:/resource/org.example.library/model/library.ecore#//Book" containment="true"/>
        </eClassifiers>
      </ecore:EPackage>
      """;

  private static final String SHOP_MODEL =
      """
      <shop:Shop xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:shop="http://example.org/shop">
        <offers title="Good" pages="100"/>
        <offers title="Bad" pages="0"/>
      </shop:Shop>
      """;

  private static final String OF_BOOKS =
      "context Shop inv HasPages: self.offers->forAll(book | book.pages > 0)\n";

  @TempDir Path folder;
  private Path ecore;
  private Path model;

  @BeforeEach
  void write() throws IOException {
    ecore = Files.writeString(folder.resolve("library.ecore"), ECORE);
    model = Files.writeString(folder.resolve("model.xmi"), MODEL);
  }

  @Test
  void aViolationPointsToItsLineAndEndsWithOne() throws IOException {
    Path ocl = ocl("context Book inv HasPages: self.pages > 0\n");
    new Program()
        .run("validate", "--metamodel", ecore, "--ocl", ocl, model)
        .expect(1)
        .says("model.xmi:4:3: error:")
        .says("[ocl.violated Book::HasPages]")
        .says("evaluated 2 times");
  }

  @Test
  void whatHoldsEndsWithZeroAndSaysWhatWasEvaluated() throws IOException {
    Path ocl = ocl("context Book inv HasTitle: self.title.size() > 0\n");
    new Program()
        .run("validate", "--metamodel", ecore, "--ocl", ocl, model)
        .expect(0)
        .says("0 errors, 0 warnings in 3 files: 3 elements, 1 constraint evaluated 2 times");
  }

  @Test
  void whatTheMetamodelDemandsIsCheckedAndMayBeSuppressed() throws IOException {
    Files.writeString(
        ecore,
        ECORE.replace("name=\"pages\"", "lowerBound=\"1\" unsettable=\"true\" name=\"pages\""));
    Files.writeString(model, MODEL.replace("pages=\"-1\"", ""));
    new Program()
        .run("validate", "--metamodel", ecore, model)
        .expect(1)
        .says("model.xmi:4:3: error: `pages` has no value, but needs one. [ecore.required]")
        .says("0 constraints evaluated 0 times, 2 metamodel checks");
    Path template = Files.writeString(folder.resolve("main.mtl"), TEMPLATE);
    Path out = folder.resolve("made");
    Path decided =
        Files.writeString(
            folder.resolve("decided.yaml"),
            """
            - id: ecore.required
              reason: The pages are counted later.
              expires: 2999-01-01
            """);
    Object[] command = {"generate", "--metamodel", ecore, "--template", template, model, "-o", out};
    new Program().run(command).expect(1).says("[ecore.required]");
    assertTrue(Files.notExists(out));
    Object[] suppressed = Arrays.copyOf(command, command.length + 2);
    suppressed[command.length] = "--suppressions";
    suppressed[command.length + 1] = decided;
    new Program().run(suppressed).expect(0);
    assertTrue(Files.exists(out.resolve("good.txt")));
    Files.delete(out.resolve("good.txt"));
    Object[] lenient = Arrays.copyOf(command, command.length + 1);
    lenient[command.length] = "--lenient";
    new Program().run(lenient).expect(0).says("warning: `pages` has no value");
    assertTrue(Files.exists(out.resolve("good.txt")), "as Acceleo, which does not look at it");
  }

  @Test
  void nothingEvaluatedIsNoPass() throws IOException {
    new Program()
        .run("validate", "--metamodel", ecore, "--ocl", ocl("-- nothing\n"), model)
        .expect(1)
        .says("ocl.nothing-evaluated");
    new Program().run("validate", "--metamodel", ecore, model).expect(1);
    new Program()
        .run("validate", "--allow-empty", "--metamodel", ecore, model)
        .expect(0)
        .says("info: Only the form of the models was checked: no constraint is about them.");
    new Program().run("validate", "--allow-empty", folder).expect(2).says("is for model files");
  }

  @Test
  void aConstraintThatTakesTooLongIsNoPass() throws IOException {
    Path ocl =
        ocl(
            """
            context Book
              inv Slow: Sequence{1..5000}->forAll(a, b |
                Sequence{1..5000}->forAll(c, d | a + b + c + d > 0))
              inv Fast: self.title <> ''
            """);
    Object[] command = {"validate", "--metamodel", ecore, "--ocl", ocl, model, "--time-limit", 1};
    new Program()
        .run(command)
        .expect(1)
        .says("rules.ocl:2:3: error: 'Slow' was abandoned")
        .says("it takes more than 1 s of processor time. It left 2 of 2 elements unchecked.")
        .says("[ocl.limit Book::Slow]")
        .says("1 error, 0 warnings")
        .says("2 constraints evaluated 3 times");
    command[command.length - 1] = 0;
    new Program().run(command).expect(2).says("--time-limit");
  }

  @Test
  void jsonIsForPrograms() throws IOException {
    Path ocl = ocl("context Book inv HasPages: self.pages > 0\n");
    Program.Ended ended =
        new Program()
            .run("validate", "--format", "json", "--metamodel", ecore, "--ocl", ocl, model)
            .expect(1);
    var findings = new ObjectMapper().readTree(ended.out()).get("findings");
    assertEquals(1, findings.size());
    assertEquals(4, findings.get(0).get("line").asInt());
  }

  @Test
  void aModelThatIsTooLargeForTheMemoryIsAFinding() throws IOException {
    String books = "  <books title=\"A book among many others\" pages=\"1\"/>\n".repeat(500_000);
    Files.writeString(model, MODEL.replace("</library", books + "</library"));
    new Program()
        .with("JAVA_TOOL_OPTIONS", "-Xmx48m")
        .run("validate", "--metamodel", ecore, "--ocl", ocl("context Book inv A: true\n"), model)
        .expect(3)
        .says("[eventchain.memory]")
        .says("EVENTCHAIN_MEMORY");
  }

  @Test
  void whatTheMetamodelStatesItselfIsChecked() {
    Path files = Program.ROOT.resolve("tests/fixtures/models/annotated");
    new Program()
        .run(
            "validate", "--metamodel", files.resolve("metamodel.ecore"), files.resolve("model.xmi"))
        .expect(1)
        .says("An item of 3.0 has no name [ocl.violated Item::Named]")
        .says("model.xmi:5:3")
        .says("metamodel.ecore:24:7")
        .says("'Audited' of Shop is not checked")
        .says("5 constraints evaluated 17 times");
  }

  @Test
  void aTraceNamesTheTemplateLineAndTheElementOfEachLine() throws IOException {
    Path template = Files.writeString(folder.resolve("main.mtl"), TEMPLATE);
    Path out = folder.resolve("traced");
    new Program()
        .run("generate", "--metamodel", ecore, "--template", template, model, "-o", out, "--trace")
        .expect(0);
    JsonNode trace = new ObjectMapper().readTree(out.resolve("trace.json").toFile());
    JsonNode line = trace.at("/files/0/lines/0");
    assertEquals("bad.txt", trace.at("/files/0/file").asText());
    assertEquals(1, line.get("first").asInt());
    assertEquals(1, line.get("last").asInt());
    assertEquals(6, line.at("/from/0/line").asInt());
    assertEquals("Library/books[1]", line.at("/from/0/element").asText());
    assertEquals(4, line.at("/from/0/modelLine").asInt());
  }

  @Test
  void sarifListsExactlyTheViolations() throws IOException {
    Path ocl = ocl("context Book inv HasPages: self.pages > 0\n");
    Program.Ended ended =
        new Program()
            .run("validate", "--format", "sarif", "--metamodel", ecore, "--ocl", ocl, model)
            .expect(1);
    JsonNode results = new ObjectMapper().readTree(ended.out()).at("/runs/0/results");
    assertEquals(1, results.size(), ended.out());
    JsonNode place = results.at("/0/locations/0");
    assertEquals("ocl.violated/Book::HasPages", results.at("/0/ruleId").asText());
    assertEquals(4, place.at("/physicalLocation/region/startLine").asInt());
    assertEquals(3, place.at("/physicalLocation/region/startColumn").asInt());
    assertEquals("Library/books[1]", place.at("/logicalLocations/0/fullyQualifiedName").asText());
  }

  @Test
  void filesHaveTheNamesThatTheyWereGiven() throws IOException {
    Path ocl = ocl("context Book inv HasPages: self.pages > 0\n");
    Path relative = Program.ROOT.relativize(model.toRealPath());
    Program.Ended ended =
        new Program().run("validate", "--metamodel", ecore, "--ocl", ocl, relative).expect(1);
    assertTrue(ended.out().startsWith(relative + ":4:3: error:"), ended.out());
  }

  @Test
  void referencesStayInTheFoldersOfTheNamedFiles() throws IOException {
    Path models = Files.createDirectories(folder.resolve("models"));
    Path metamodels = Files.createDirectories(folder.resolve("metamodels"));
    Path beside = Files.createDirectories(folder.resolve("beside"));
    Path library = Files.move(ecore, metamodels.resolve("library.ecore"));
    Files.writeString(beside.resolve("other.xmi"), MODEL);
    Path linked =
        Files.writeString(
            models.resolve("model.xmi"),
            MODEL.replace(
                "<books title=\"Bad\" pages=\"-1\"/>",
                "<books href=\"../beside/other.xmi#//@books.0\"/>"));
    Path ocl = ocl("context Book inv HasPages: self.pages > 0\n");
    new Program()
        .run("validate", "--metamodel", library, "--ocl", ocl, linked)
        .expect(2)
        .says("xmi.href.refused");
  }

  /** Metamodels refer to each other as projects of a workspace, wherever that is. */
  /** A metamodel may refer to another one by its file or by its namespace, in any order. */
  @Test
  void metamodelsMayBeNamedInAnyOrder() throws IOException {
    Path low = Files.createDirectories(folder.resolve("low"));
    Path base = Files.writeString(low.resolve("library.ecore"), ECORE);
    Path high = Files.createDirectories(folder.resolve("high"));
    String shelf =
        SHOP.replaceAll("platform:/resource/org.example.library/model/library.ecore", "%s");
    Path byFile =
        Files.writeString(high.resolve("file.ecore"), shelf.formatted("../low/library.ecore"));
    Path byName =
        Files.writeString(
            high.resolve("name.ecore"), shelf.formatted("http://example.org/library"));
    Path shop = Files.writeString(high.resolve("shop.xmi"), SHOP_MODEL);
    Object rules = ocl(OF_BOOKS);
    new Program()
        .run("validate", "--metamodel", byFile, "--ocl", rules, shop)
        .expect(2)
        .says("leaves the folders of the given files")
        .says("a metamodel by --metamodel")
        .says("--root DIR");
    for (Path upper : List.of(byFile, byName)) {
      new Program()
          .run("validate", "--metamodel", upper, "--metamodel", base, "--ocl", rules, shop)
          .expect(1)
          .says("[ocl.violated Shop::HasPages]");
    }
  }

  @Test
  void referencesIntoAWorkspaceAreFollowedWhereTheCommandSaysItIs() throws IOException {
    Path workspace = Files.createDirectories(folder.resolve("elsewhere/workspace"));
    Path base = Files.createDirectories(workspace.resolve("org.example.library/model"));
    Files.move(ecore, base.resolve("library.ecore"));
    Path shop = Files.writeString(folder.resolve("shop.ecore"), SHOP);
    Files.writeString(model, SHOP_MODEL);
    Object[] command = {"validate", "--metamodel", shop, "--ocl", ocl(OF_BOOKS), model};
    new Program()
        .run(command)
        .expect(2)
        .says("shop.ecore:4:")
        .says("[xmi.href.refused]")
        .says("--map platform:/resource/=FOLDER/");
    Object[] mapped = Arrays.copyOf(command, command.length + 2);
    mapped[command.length] = "--map";
    mapped[command.length + 1] = "platform:/resource/=" + workspace + "/";
    new Program()
        .run(mapped)
        .expect(1)
        .says("model.xmi:1:1: error:")
        .says("[ocl.violated Shop::HasPages]")
        .says("1 constraint evaluated 1 time");
    Files.writeString(model, SHOP_MODEL.replace("pages=\"0\"", "pages=\"7\""));
    new Program().run(mapped).expect(0).says("1 constraint evaluated 1 time");
    mapped[command.length + 1] = "platform:/resource/=" + base + "/";
    new Program().run(mapped).expect(2).says("names a file that does not exist");
    Files.delete(base.resolve("library.ecore"));
    Files.writeString(workspace.resolve("org.example.library/.project"), "<projectDescription/>");
    Files.writeString(base.resolve("library.ecore"), ECORE);
    Path inside = Files.createDirectories(workspace.resolve("org.example.shop/model"));
    command[2] = Files.move(shop, inside.resolve("shop.ecore"));
    new Program().run(command).expect(0).says("1 constraint evaluated 1 time");
  }

  @Test
  void aTemplateWritesItsFilesAndTouchesThemNoSecondTime() throws IOException {
    Path template = Files.writeString(folder.resolve("main.mtl"), TEMPLATE);
    Path out = folder.resolve("out");
    Object[] command = {"generate", "--metamodel", ecore, "--template", template, model, "-o", out};
    new Program().run(command).expect(0);
    Path file = out.resolve("good.txt");
    assertEquals("Good has 100 pages.\n", Files.readString(file));
    FileTime before = Files.getLastModifiedTime(file);
    new Program().run(command).expect(0);
    assertEquals(before, Files.getLastModifiedTime(file));
  }

  @Test
  void aTemplateCallsTheServicesThatTheCommandNames() throws IOException {
    String words =
        """
        public class Words extends Thread {
          public static String loud(String word) { return word.toUpperCase(); }
        }
        """;
    Path source = Files.writeString(folder.resolve("Words.java"), words);
    Path classes = Files.createDirectories(folder.resolve("classes"));
    int failed =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, "-d", classes.toString(), source.toString());
    assertEquals(0, failed);
    String call = "[invoke('Words', 'loud(String)', Sequence{book.title})/]";
    Path template =
        Files.writeString(folder.resolve("main.mtl"), TEMPLATE.replace("[book.title/]", call));
    Path out = folder.resolve("out");
    Object[] command = {"generate", "--metamodel", ecore, "--template", template, model, "-o", out};
    new Program().run(command).expect(2).says("[m2t.service]").says("main.mtl:6:");
    Object[] withServices = Arrays.copyOf(command, command.length + 2);
    withServices[command.length] = "--services";
    withServices[command.length + 1] = classes;
    new Program().run(withServices).expect(0);
    assertEquals("GOOD has 100 pages.\n", Files.readString(out.resolve("good.txt")));
    String inherited = "[invoke('Words', 'getAllStackTraces()', Sequence{})/]";
    Files.writeString(template, TEMPLATE.replace("[book.title/]", inherited));
    new Program()
        .run(withServices)
        .expect(1)
        .says("[m2t.service]")
        .says("its class has no such public method");
    assertEquals("invalid has 100 pages.\n", Files.readString(out.resolve("good.txt")));
  }

  private Path ocl(String text) throws IOException {
    return Files.writeString(folder.resolve("rules.ocl"), text);
  }
}
