package dev.eventchain.jsonmodels;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcoreFactory;
import org.junit.jupiter.api.Test;

class InstanceModelerTest {

  private static final EPackage CHAIN = TestMetamodels.eventChain();
  private static final InstanceModeler CHAINS = new InstanceModeler(List.of(CHAIN));

  @Test
  void elementsKeepTheirPointers() {
    Modeled<EObject> made =
        one(
            """
            {"eClass": "EventChain", "id": "c",
             "software": [{"eClass": "SoftwareNode", "id": "a", "name": "A"}]}
            """);
    var location = made.origins().locate(made.root().eContents().get(0));
    assertEquals("/software/0", location.element());
    assertEquals(2, location.line());
    assertEquals(15, location.column());
  }

  @Test
  void anIdIsAlsoTheAttributeOfThatName() {
    EObject chain =
        one("{\"eClass\": \"EventChain\", \"requirements\": [{\"id\": \"R-1\"}]}").root();
    EObject requirement = chain.eContents().get(0);
    assertEquals("R-1", requirement.eGet(requirement.eClass().getEStructuralFeature("id")));
  }

  @Test
  void aClassNameOfTwoPackagesNeedsItsPackage() {
    InstanceModeler modeler = new InstanceModeler(List.of(withBox("store"), withBox("archive")));
    List<Diagnostic> found =
        modeler.model(SourceText.of("a.json", "{\"eClass\": \"Box\"}")).diagnostics();
    assertEquals("modeler.class.ambiguous", found.get(0).id());
    Modeled<List<EObject>> made =
        modeler.model(SourceText.of("b.json", "{\"eClass\": \"archive.Box\"}"));
    assertEquals(List.of(), made.diagnostics());
    assertEquals("archive", made.root().get(0).eClass().getEPackage().getName());
  }

  private static EPackage withBox(String name) {
    EPackage ePackage = EcoreFactory.eINSTANCE.createEPackage();
    ePackage.setName(name);
    ePackage.setNsURI("http://example.org/" + name);
    EClass box = EcoreFactory.eINSTANCE.createEClass();
    box.setName("Box");
    ePackage.getEClassifiers().add(box);
    return ePackage;
  }

  @Test
  void oneRootMayNotHaveStrayObjectsBesideIt() {
    Modeled<EObject> made =
        one("[{\"eClass\": \"EventChain\", \"name\": \"c\"}, {\"eClass\": \"Data\"}]");
    assertEquals(List.of("modeler.containment.missing"), ids(made.diagnostics()));
    assertEquals("/1", made.diagnostics().get(0).location().element());
  }

  @Test
  void oneRootMayNotBeTwo() {
    Modeled<EObject> made =
        one("[{\"eClass\": \"EventChain\", \"name\": \"c\"}, {\"eClass\": \"EventChain\"}]");
    assertEquals(List.of("modeler.containment.missing"), ids(made.diagnostics()));
  }

  @Test
  void aMissingRootIsAFindingAndNoNull() {
    Modeled<EObject> made = one("[]");
    assertEquals("EventChain", made.root().eClass().getName());
    assertTrue(ids(made.diagnostics()).contains("modeler.instance.empty"));
  }

  @Test
  void everyTruncationIsRefusedWithAPlace() throws IOException {
    String text =
        Files.readString(Path.of("src/test/resources/cases/instance/good-nested/instance.json"))
            .strip();
    for (int length = 0; length < text.length(); length++) {
      SourceText cut = SourceText.of("cut.json", text.substring(0, length));
      DiagnosticException refused =
          assertThrows(DiagnosticException.class, () -> CHAINS.model(cut), cut::text);
      assertEquals("modeler.json.syntax", refused.diagnostics().get(0).id());
      assertTrue(refused.diagnostics().get(0).location().line() > 0);
    }
  }

  @Test
  void everyValueIsFoundAtItsPlace() throws IOException {
    String source =
        Files.readString(Path.of("src/test/resources/cases/instance/good-nested/instance.json"));
    Document text = JsonDocument.parse(SourceText.of("instance.json", source));
    assertEquals(1, text.at("").line());
    assertEquals("\"Emma.\",", textAt(text, source, "/items/1/title"));
    assertEquals("-128,", textAt(text, source, "/items/0/weight"));
    assertEquals("[\"a\",", textAt(text, source, "/items/0/keywords"));
    assertEquals("\"b\"],", textAt(text, source, "/items/0/keywords/1"));
    assertEquals("{\"id\":", textAt(text, source, "/sections/0/sections/0"));
    assertEquals("{\"eClass\":", textAt(text, source, "/items/1/nothing/here"));
  }

  private static String textAt(Document text, String source, String pointer) {
    var location = text.at(pointer);
    assertEquals(pointer, location.element());
    String line = source.lines().toList().get(location.line() - 1);
    return line.substring(location.column() - 1).split("[ }]", 2)[0];
  }

  private static Modeled<EObject> one(String json) {
    return CHAINS.modelOne(
        SourceText.of("instance.json", json), (EClass) CHAIN.getEClassifier("EventChain"));
  }

  private static List<String> ids(List<Diagnostic> diagnostics) {
    return diagnostics.stream().map(Diagnostic::id).toList();
  }
}
