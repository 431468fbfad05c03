package dev.eventchain.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.xmi.LoadedModel;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class XmiStoreTest {

  private static final Path CASES = Path.of("src/test/resources/xmi");

  @TempDir Path folder;

  static Stream<String> cases() throws IOException {
    try (Stream<Path> folders = Files.list(CASES)) {
      return folders.map(path -> path.getFileName().toString()).sorted().toList().stream();
    }
  }

  /** Test cases, one per folder; {@code expected.txt} holds the findings or the saved model. */
  @ParameterizedTest
  @MethodSource("cases")
  void readsOrRefusesAFile(String name) throws IOException {
    Path folder = CASES.resolve(name);
    ExpectedFile.check(folder.resolve("expected.txt"), outcome(folder));
  }

  private static String outcome(Path project) {
    try {
      XmiStore store = EventChainMetamodel.store(project);
      Path metamodel = project.resolve("metamodel.ecore");
      if (Files.exists(metamodel)) {
        store.loadMetamodel(metamodel);
      }
      Path ecore = project.resolve("model.ecore");
      if (Files.exists(ecore)) {
        return "loaded " + store.loadMetamodel(ecore).get(0).getName() + "\n";
      }
      List<EObject> roots = store.load(project.resolve("model.xmi")).roots();
      return new String(XmiStore.toBytes(roots), StandardCharsets.UTF_8);
    } catch (DiagnosticException e) {
      assertEquals(DiagnosticException.Reason.INPUT, e.reason());
      return DiagnosticFormat.TEXT.render(e.diagnostics()).replace(project + "/", "");
    }
  }

  @Test
  void locatesEveryElement() {
    LoadedModel model = load("good-chain");
    EventChain chain = (EventChain) model.roots().get(0);
    SourceLocation node = model.origins().locate(chain.getSoftware().get(0));
    assertEquals("src/test/resources/xmi/good-chain/model.xmi", node.file());
    assertEquals(3, node.line());
    assertEquals(3, node.column());
    assertEquals("EventChain[aeb]/software[A]", node.element());
    assertTrue(node.excerpt().startsWith("  <software name=\"A\""));
    assertEquals(2, model.origins().locate(chain).line());
    assertEquals(5, model.origins().locate(chain.getData().get(1)).line());
  }

  @Test
  void locatesAnAddedElementAtItsContainer() {
    LoadedModel model = load("good-chain");
    EventChain chain = (EventChain) model.roots().get(0);
    SoftwareNode added = EventchainFactory.eINSTANCE.createSoftwareNode();
    assertEquals("SoftwareNode", model.origins().locate(added).element());
    assertEquals(0, model.origins().locate(added).line());
    chain.getSoftware().add(added);
    assertEquals(2, model.origins().locate(added).line());
    assertEquals("EventChain[aeb]/software[1]", model.origins().locate(added).element());
  }

  @Test
  void resolvesReferencesBetweenFiles() {
    EventChain chain = (EventChain) load("reference-to-another-file").roots().get(0);
    SoftwareNode node = chain.getSoftware().get(0);
    assertEquals("x", node.getInput().get(0).getName());
    assertEquals("y", node.getOutput().get(0).getName());
  }

  @Test
  void registersTheMetamodelsThatAMetamodelRefersTo() {
    Path project = CASES.resolve("good-foreign-metamodel");
    XmiStore store = EventChainMetamodel.store(project);
    List<EPackage> packages = store.loadMetamodel(project.resolve("metamodel.ecore"));
    assertEquals(List.of("library"), packages.stream().map(EPackage::getName).toList());
    EObject library = store.load(project.resolve("model.xmi")).roots().get(0);
    assertEquals("Library", library.eClass().getName());
  }

  @Test
  void readsTheEventChainMetamodelAsAnyOther() throws IOException {
    Path ecore = Files.writeString(folder.resolve("eventchain.ecore"), EventChainMetamodel.text());
    XmiStore store = EventChainMetamodel.store(folder);
    EPackage loaded = store.loadMetamodel(ecore).get(0);
    assertEquals("eventchain", loaded.getName());
    byte[] written = XmiStore.toBytes(loaded);
    Path again = Files.write(folder.resolve("again.ecore"), written);
    assertArrayEquals(
        written, XmiStore.toBytes(EventChainMetamodel.store(folder).loadMetamodel(again).get(0)));
  }

  @Test
  void keepsRegistriesApart() {
    Path project = CASES.resolve("good-foreign-metamodel");
    EventChainMetamodel.store(project).loadMetamodel(project.resolve("metamodel.ecore"));
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class,
            () -> EventChainMetamodel.store(project).load(project.resolve("model.xmi")));
    assertEquals("xmi.package.unknown", refused.diagnostics().get(0).id());
  }

  @Test
  void refusesASymbolicLinkThatLeavesTheProject() throws IOException {
    Path outside = Files.createDirectory(folder.resolve("outside"));
    Path project = Files.createDirectory(folder.resolve("project"));
    Files.copy(CASES.resolve("good-chain/model.xmi"), outside.resolve("lib.xmi"));
    Files.createSymbolicLink(project.resolve("link"), outside);
    String text = Files.readString(CASES.resolve("good-chain/model.xmi"));
    Path model =
        Files.writeString(
            project.resolve("model.xmi"), text.replace("//@data.0", "link/lib.xmi#//@data.0"));
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class, () -> EventChainMetamodel.store(project).load(model));
    assertEquals("xmi.href.refused", refused.diagnostics().get(0).id());
  }

  @Test
  void saysThatAFileIsMissing() {
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class,
            () -> EventChainMetamodel.store(folder).load(folder.resolve("no.xmi")));
    assertEquals("file.missing", refused.diagnostics().get(0).id());
    assertEquals(1, refused.diagnostics().size());
  }

  @Test
  void survivesEveryTruncation() throws IOException {
    String text = Files.readString(CASES.resolve("good-foreign-metamodel/model.xmi"));
    Path source = CASES.resolve("good-foreign-metamodel");
    Files.createDirectory(folder.resolve("people"));
    Files.copy(source.resolve("metamodel.ecore"), folder.resolve("metamodel.ecore"));
    Files.copy(source.resolve("people/people.ecore"), folder.resolve("people/people.ecore"));
    XmiStore store = EventChainMetamodel.store(folder);
    store.loadMetamodel(folder.resolve("metamodel.ecore"));
    for (int length = 0; length < text.stripTrailing().length(); length++) {
      Path model = Files.writeString(folder.resolve("model.xmi"), text.substring(0, length));
      DiagnosticException refused =
          assertThrows(DiagnosticException.class, () -> store.load(model));
      assertFalse(refused.diagnostics().get(0).message().contains("Exception"));
    }
  }

  @Test
  void readsUtf16AndSaysWhenItIsCutInTheMiddle() throws IOException {
    String text = Files.readString(CASES.resolve("good-chain/model.xmi"));
    String declared = text.replace("UTF-8", "UTF-16");
    byte[] bytes = declared.getBytes(StandardCharsets.UTF_16);
    Path model = Files.write(folder.resolve("model.xmi"), bytes);
    assertEquals(1, EventChainMetamodel.store(folder).load(model).roots().size());
    Files.write(model, Arrays.copyOf(bytes, bytes.length - 1));
    assertEquals("file.encoding", refusal(model).id());
    Files.write(model, Arrays.copyOf(bytes, bytes.length - 40));
    assertEquals("xmi.syntax", refusal(model).id());
    Files.write(model, declared.getBytes(StandardCharsets.UTF_16LE));
    assertEquals("file.encoding", refusal(model).id());
  }

  @Test
  void refusesWhatIsNoFile() throws IOException {
    assertEquals("file.unreadable", refusal(folder).id());
    assertEquals("file.unreadable", refusal(Path.of("/dev/zero")).id());
    Path large = folder.resolve("large.xmi");
    try (RandomAccessFile file = new RandomAccessFile(large.toFile(), "rw")) {
      file.setLength((256L << 20) + 1);
    }
    assertEquals("file.unreadable", refusal(large).id());
    assertTrue(refusal(large).message().contains("268435456"), refusal(large).message());
  }

  @Test
  void refusesAHundredThousandLevels() throws IOException {
    String text = "<a>".repeat(100_000) + "</a>".repeat(100_000);
    Diagnostic refusal = refusal(Files.writeString(folder.resolve("model.xmi"), text));
    assertEquals("xmi.package.unknown", refusal.id());
    Path chain = CASES.resolve("good-chain/model.xmi");
    String deep = Files.readString(chain).replace("</eventchain:EventChain>", text);
    Files.writeString(folder.resolve("model.xmi"), deep);
    assertTrue(
        refusals(folder.resolve("model.xmi")).stream()
            .anyMatch(d -> d.message().contains("500 levels")));
  }

  @Test
  void readsModelsThatReferToEachOtherTogether() {
    Path project = CASES.resolve("reference-to-another-file");
    Path first = project.resolve("model.xmi");
    Path second = project.resolve("parts/lib.xmi");
    List<LoadedModel> models =
        EventChainMetamodel.store(project).loadAll(List.of(first, second, first));
    assertEquals(2, models.size());
    EventChain chain = (EventChain) models.get(0).roots().get(0);
    EventChain library = (EventChain) models.get(1).roots().get(0);
    assertSame(library.getData().get(0), chain.getSoftware().get(0).getInput().get(0));
    assertEquals(3, models.get(0).origins().locate(library.getData().get(0)).line());
  }

  @Test
  void aMetamodelIsOneObjectWhicheverFileLeadsToIt() {
    Path project = CASES.resolve("good-foreign-metamodel");
    XmiStore store = EventChainMetamodel.store(project);
    EPackage library = store.loadMetamodel(project.resolve("metamodel.ecore")).get(0);
    EPackage people = store.loadMetamodel(project.resolve("people/people.ecore")).get(0);
    EClass person = (EClass) people.getEClassifier("Person");
    EClass item = (EClass) library.getEClassifier("Item");
    assertSame(person, item.getEStructuralFeature("author").getEType());
    assertSame(library, store.loadMetamodel(project.resolve("metamodel.ecore")).get(0));
  }

  @Test
  void refusesTwoMetamodelsWithOneNamespace() throws IOException {
    Path source = CASES.resolve("good-foreign-metamodel/people/people.ecore");
    Path first = Files.copy(source, folder.resolve("first.ecore"));
    Path second = Files.copy(source, folder.resolve("second.ecore"));
    XmiStore store = EventChainMetamodel.store(folder);
    EPackage people = store.loadMetamodel(first).get(0);
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> store.loadMetamodel(second));
    Diagnostic duplicate = refused.diagnostics().get(0);
    assertEquals("xmi.namespace.duplicate", duplicate.id());
    assertTrue(duplicate.location().file().endsWith("second.ecore"));
    assertTrue(duplicate.related().get(0).file().endsWith("first.ecore"));
    assertSame(people, store.loadMetamodel(first).get(0));
  }

  private Diagnostic refusal(Path model) {
    return refusals(model).get(0);
  }

  private List<Diagnostic> refusals(Path model) {
    return assertThrows(
            DiagnosticException.class, () -> EventChainMetamodel.store(folder).load(model))
        .diagnostics();
  }

  @Test
  void writesARootOfSeveralAlone() throws IOException {
    EventChain first = EventchainFactory.eINSTANCE.createEventChain();
    first.setName("first");
    EventChain second = EventchainFactory.eINSTANCE.createEventChain();
    second.setName("second");
    byte[] both = XmiStore.toBytes(List.of(first, second));
    LoadedModel model =
        EventChainMetamodel.store(folder).load(Files.write(folder.resolve("model.xmi"), both));
    assertEquals(2, model.roots().size());
    assertArrayEquals(both, XmiStore.toBytes(model.roots()));
    String alone = new String(XmiStore.toBytes(model.roots().get(1)), StandardCharsets.UTF_8);
    assertTrue(alone.contains("name=\"second\""));
    assertFalse(alone.contains("first"));
    assertEquals(2, model.roots().size());
    assertNotEquals(null, model.roots().get(1).eResource());
  }

  @Test
  void refusesToWriteWhatXmlCannotHold() {
    EventChain chain = EventchainFactory.eINSTANCE.createEventChain();
    chain.setName("bell\u0007");
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> XmiStore.toBytes(chain));
    assertEquals("xmi.unwritable", refused.diagnostics().get(0).id());
    chain.setName("lone \uD800 surrogate");
    assertThrows(DiagnosticException.class, () -> XmiStore.toBytes(chain));
  }

  @Test
  void refusesToWriteAReferenceToAnElementOutsideOfAnyModel() {
    EventChain chain = EventchainFactory.eINSTANCE.createEventChain();
    SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();
    node.getInput().add(EventchainFactory.eINSTANCE.createData());
    chain.getSoftware().add(node);
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> XmiStore.toBytes(chain));
    assertEquals("xmi.unwritable", refused.diagnostics().get(0).id());
    assertEquals(null, chain.eResource());
  }

  @Test
  void holdsTheStandardRules() {
    assertTrue(EventChainMetamodel.constraints().text().contains("inv HasInputAndOutputData"));
  }

  private static LoadedModel load(String name) {
    Path project = CASES.resolve(name);
    return EventChainMetamodel.store(project).load(project.resolve("model.xmi"));
  }
}
