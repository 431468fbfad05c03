package dev.eventchain.xmi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the files that references lead to, by different names. */
class ReferredFilesTest {

  private static final String HEAD =
      "xmi:version=\"2.0\" xmlns:xmi=\"http://www.omg.org/XMI\""
          + " xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"";

  private static final String ECORE =
      """
      <ecore:EPackage HEAD xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="NAME" nsURI="http://example.org/NAME" nsPrefix="NAME">
        <eClassifiers xsi:type="ecore:EClass" name="Car" SUPER>
          <eStructuralFeatures xsi:type="ecore:EReference" name="next" eType="#//Car" upperBound="-1"/>
        </eClassifiers>
      </ecore:EPackage>
      """;

  private static final String MODEL =
      "<car:Car HEAD xmlns:car=\"http://example.org/car\">%s</car:Car>";

  @TempDir Path folder;
  private Path given;
  private Path workspace;

  @BeforeEach
  void write() throws IOException {
    given = Files.createDirectories(folder.resolve("given"));
    workspace = Files.createDirectories(folder.resolve("work space"));
    Files.createDirectories(workspace.resolve("lib/model"));
    Files.writeString(workspace.resolve("lib/model/base.ecore"), ecore("base", ""));
    Files.writeString(given.resolve("car.ecore"), ecore("car", ""));
  }

  private static String ecore(String name, String superType) {
    return ECORE.replace("HEAD", HEAD).replace("NAME", name).replace("SUPER", superType);
  }

  private EPackage loadExtending(String reference, Map<String, Path> map) throws IOException {
    String text = ecore("car", "eSuperTypes=\"" + reference + "#//Car\"");
    Path file = Files.writeString(given.resolve("car.ecore"), text);
    return new XmiStore(List.of(given), map).loadMetamodel(file).get(0);
  }

  private static String superTypeOf(EPackage ePackage) {
    EClass car = (EClass) ePackage.getEClassifier("Car");
    return car.getESuperTypes().get(0).getEPackage().getName();
  }

  @Test
  void aBeginningOfReferencesIsMappedToAFolder() throws IOException {
    Map<String, Path> map = Map.of("platform:/resource/", workspace);
    assertEquals(
        "base", superTypeOf(loadExtending("platform:/resource/lib/model/base.ecore", map)));
    Map<String, Path> longer =
        Map.of("http://example.org/", given, "http://example.org/files/", workspace);
    assertEquals(
        "base",
        superTypeOf(loadExtending("http://example.org/files/lib/model/base.ecore", longer)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "http://example.org/base",
        "platform:/plugin/org.example.base/model/base.ecore",
        "../../org.example.base/model/base.ecore",
      })
  void aWholeReferenceIsMappedToAFile(String reference) throws IOException {
    Path base = workspace.resolve("lib/model/base.ecore");
    assertEquals("base", superTypeOf(loadExtending(reference, Map.of(reference, base))));
    assertEquals("xmi.href.refused", refusal(reference, Map.of()).id());
  }

  @ParameterizedTest
  @ValueSource(strings = {"http://example.org/base", "platform:/elsewhere/base.ecore"})
  void aReferenceByAnyUriIsNamedWithTheOptionThatGivesItsFile(String reference) {
    Diagnostic refused = refusal(reference, Map.of());
    assertTrue(refused.message().contains(reference), refused.message());
    assertEquals("Say which file that is: --map " + reference + "=FILE", refused.hint());
  }

  /** A metamodel as in the plug-ins of EMF, with Ecore next to it. */
  @Test
  void ecoreBesideAMappedMetamodelIsTheOneThatIsAlwaysThere() throws IOException {
    String ecore =
        ecore("base", "")
            .replace(
                "#//Car", "ecore:EClass ../../org.eclipse.emf.ecore/model/Ecore.ecore#//EClass");
    Path base = Files.writeString(workspace.resolve("lib/model/base.ecore"), ecore);
    String uri = "platform:/plugin/org.example.base/model/base.ecore";
    EClass car = (EClass) loadExtending(uri, Map.of(uri, base)).getEClassifier("Car");
    EClass type = (EClass) car.getESuperTypes().get(0).getEStructuralFeature("next").getEType();
    assertSame(EcorePackage.Literals.ECLASS, type);
  }

  @Test
  void aMappedFolderMayBeReferredIntoByARelativePath() throws IOException {
    String reference = "../work%20space/lib/model/base.ecore";
    assertEquals("base", superTypeOf(loadExtending(reference, Map.of("x:/", workspace))));
    assertEquals("xmi.href.refused", refusal(reference, Map.of()).id());
  }

  @Test
  void aMapDoesNotLeadOutOfItsFolder() {
    Map<String, Path> map = Map.of("platform:/resource/", workspace.resolve("lib/model"));
    Diagnostic refused = refusal("platform:/resource/../../../car.ecore", map);
    assertEquals("xmi.href.refused", refused.id());
  }

  @ParameterizedTest
  @CsvSource({
    "work space/car/model, lib/model/base.ecore",
    "work space/car/deep/er, lib/model/base.ecore",
    "work space/lib/other, lib/model/base.ecore",
    "work space/features/car, lib/model/base.ecore",
  })
  void aProjectAboveOrBesideTheFoldersOfAFileIsFound(String home, String reference)
      throws IOException {
    given = Files.createDirectories(folder.resolve(home));
    Files.writeString(workspace.resolve("lib/.project"), "<projectDescription/>");
    assertEquals("base", superTypeOf(loadExtending("platform:/resource/" + reference, Map.of())));
    assertEquals("base", superTypeOf(loadExtending("platform:/plugin/" + reference, Map.of())));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "lib/model/base.ecore",
        "../work%20space/lib/model/base.ecore",
        "car/../lib/model/base.ecore",
        "car/link/model/base.ecore",
        "./lib/model/base.ecore",
        "lib/missing.ecore",
      })
  void aFolderThatIsNoProjectIsNoneNorWhatLiesOutsideOfOne(String reference) throws IOException {
    given = Files.createDirectories(workspace.resolve("car/model"));
    Files.writeString(workspace.resolve("car/.project"), "<projectDescription/>");
    Files.createSymbolicLink(workspace.resolve("car/link"), workspace.resolve("lib"));
    Diagnostic refused = refusal("platform:/resource/" + reference, Map.of());
    assertEquals("xmi.href.refused", refused.id());
    assertTrue(refused.hint().contains("--map platform:/resource/=FOLDER/"), refused.hint());
  }

  @Test
  void aProjectThatIsFoundHasTheNameThatTheFileHas() throws IOException {
    given = Files.createDirectories(workspace.resolve("car/model"));
    Files.writeString(workspace.resolve("lib/.project"), "<projectDescription/>");
    Files.writeString(workspace.resolve("lib/model/base.ecore"), "<a");
    Path here = Path.of("").toAbsolutePath();
    given = here.relativize(given);
    String reference = "platform:/resource/lib/model/base.ecore";
    String expected = here.relativize(workspace.resolve("lib/model/base.ecore")).toString();
    assertTrue(
        refusals(reference, Map.of()).stream()
            .anyMatch(
                found ->
                    found.id().equals("xmi.syntax") && found.location().file().equals(expected)));
  }

  @Test
  void aWorkspaceThatIsNotGivenIsNamedWithTheOptionThatGivesIt() {
    Diagnostic refused = refusal("platform:/resource/lib/model/base.ecore", Map.of());
    assertEquals("xmi.href.refused", refused.id());
    assertTrue(refused.hint().contains("--map platform:/resource/=FOLDER/"), refused.hint());
  }

  private Diagnostic refusal(String reference, Map<String, Path> map) {
    return refusals(reference, map).get(0);
  }

  private List<Diagnostic> refusals(String reference, Map<String, Path> map) {
    return assertThrows(DiagnosticException.class, () -> loadExtending(reference, map))
        .diagnostics();
  }

  @Test
  void aFileByTwoNamesIsOne() throws IOException {
    Path second = model("second.xmi", "");
    Path link = Files.createSymbolicLink(given.resolve("link.xmi"), second);
    String hrefs =
        List.of("second.xmi", second.toUri().toString(), "link.xmi").stream()
            .map(name -> "<next href=\"" + name.replace("file:/t", "file:///t") + "#/\"/>")
            .reduce("", String::concat);
    Path first = model("first.xmi", hrefs);
    XmiStore store = new XmiStore(given);
    store.loadMetamodel(given.resolve("car.ecore"));
    List<LoadedModel> models = store.loadAll(List.of(first, link, second));
    assertEquals(2, models.size());
    assertEquals(2, XmiStore.withReferred(models).size());
    EObject car = models.get(0).roots().get(0);
    Object next = ((List<?>) car.eGet(car.eClass().getEStructuralFeature("next"))).get(0);
    assertSame(models.get(1).roots().get(0), next);
  }

  @Test
  void twoFilesMayUseTheSameId() throws IOException {
    String second =
        Files.readString(model("second.xmi", "")).replace("<car:Car", "<car:Car xmi:id='a'");
    Files.writeString(given.resolve("second.xmi"), second);
    String hrefs = "<next href=\"#a\"/><next href=\"second.xmi#a\"/>";
    String first =
        Files.readString(model("first.xmi", hrefs)).replace("<car:Car", "<car:Car xmi:id='a'");
    Path file = Files.writeString(given.resolve("first.xmi"), first);
    XmiStore store = new XmiStore(given);
    store.loadMetamodel(given.resolve("car.ecore"));
    List<LoadedModel> models = XmiStore.withReferred(store.loadAll(List.of(file)));
    EObject car = models.get(0).roots().get(0);
    assertEquals(
        List.of(car, models.get(1).roots().get(0)),
        car.eGet(car.eClass().getEStructuralFeature("next")));
    assertEquals(List.of(), EcoreChecks.of(models).diagnostics());
  }

  @Test
  void valuesOfJavaDataTypesAreTexts() {
    Path home = Path.of("src/test/resources/ecore/good-java-data-type-kept-as-text");
    XmiStore store = new XmiStore(home);
    store.loadMetamodel(home.resolve("metamodel.ecore"));
    EObject fleet = store.load(home.resolve("model.xmi")).roots().get(0);
    assertEquals("no URL", fleet.eGet(fleet.eClass().getEStructuralFeature("other")));
    assertEquals("ACED0005", fleet.eGet(fleet.eClass().getEStructuralFeature("any")));
  }

  private Path model(String name, String content) throws IOException {
    String text = MODEL.formatted(content).replace("HEAD", HEAD);
    return Files.writeString(given.resolve(name), text);
  }
}
