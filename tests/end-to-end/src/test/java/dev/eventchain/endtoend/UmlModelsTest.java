package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.Projects;
import dev.eventchain.model.EventChainMetamodel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.ResourceSet;
import org.eclipse.emf.ecore.resource.impl.ResourceSetImpl;
import org.eclipse.uml2.uml.Class;
import org.eclipse.uml2.uml.Element;
import org.eclipse.uml2.uml.NamedElement;
import org.eclipse.uml2.uml.Property;
import org.eclipse.uml2.uml.resources.util.UMLResourcesUtil;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests models of UML, saved by Eclipse UML2 with a profile: they are read, validated and turned
 * into text without any metamodel being named.
 */
class UmlModelsTest {

  private static final Path CASE = Program.ROOT.resolve("tests/end-to-end/src/test/resources/uml");

  private static final String NAMESPACE = "http://www.eclipse.org/uml2/5.0.0/UML";

  @TempDir Path folder;
  private Path model;
  private Path rules;

  @BeforeEach
  void copy() throws IOException {
    Projects.copy(CASE, folder);
    model = folder.resolve("shop.uml");
    rules = folder.resolve("rules.ocl");
  }

  private Path changed(String from, String to) throws IOException {
    String text = Files.readString(model);
    assertTrue(text.contains(from), from);
    return Files.writeString(folder.resolve("changed.uml"), text.replace(from, to));
  }

  private Program.Ended validate(Path file) {
    return new Program().run("validate", "--ocl", rules, file);
  }

  @Test
  void templateReadsDerivedFeaturesAndStereotypes() throws IOException {
    Path out = folder.resolve("out");
    new Program()
        .run("generate", "--template", folder.resolve("java.mtl"), model, "-o", out)
        .expect(0)
        .says("3 written");
    Path expected = CASE.resolve("expected/shop/domain");
    for (String name : List.of("Customer.java", "Item.java", "Order.java")) {
      assertEquals(
          Files.readString(expected.resolve(name)),
          Files.readString(out.resolve("shop/domain").resolve(name)));
    }
  }

  @Test
  void constraintIsViolatedAtTheLineOfTheElement() throws IOException {
    validate(model)
        .expect(1)
        .says("shop.uml:12:7: error: Class 'Customer' violates 'Identified'")
        .says("1 error, 0 warnings");
    validate(changed("name=\"Order\"", "name=\"order\"")).expect(1).says("violates 'Capital'");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "http://www.eclipse.org/uml2/2.1.0/UML",
        "http://www.eclipse.org/uml2/3.0.0/UML",
        "http://www.eclipse.org/uml2/4.0.0/UML",
        "http://www.omg.org/spec/UML/20131001",
        "http://schema.omg.org/spec/UML/2.1.2",
      })
  void otherVersionsAreReadWhereTheyHaveTheSameFeatures(String namespace) throws IOException {
    validate(changed("xmlns:uml=\"" + NAMESPACE, "xmlns:uml=\"" + namespace))
        .expect(1)
        .says("violates 'Identified'")
        .says("1 error, 0 warnings");
  }

  @Test
  void primitiveTypesOfTheOmgAreThoseOfTheLibrary() throws IOException {
    Path out = folder.resolve("out");
    Path file =
        changed(
            "pathmap://UML_LIBRARIES/UMLPrimitiveTypes.library.uml",
            "http://www.omg.org/spec/UML/20131001/PrimitiveTypes.xmi");
    new Program()
        .run("generate", "--template", folder.resolve("java.mtl"), file, "-o", out)
        .expect(0);
    assertTrue(
        Files.readString(out.resolve("shop/domain/Item.java")).contains("private Integer id;"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "pathmap://UML_LIBRARIES/Nothing.library.uml",
        "pathmap://UML_LIBRARIES/../../secret.library.uml",
        "pathmap://OTHER/UMLPrimitiveTypes.library.uml",
      })
  void libraryThatDoesNotExistIsAFinding(String library) throws IOException {
    validate(
            changed(
                "pathmap://UML_LIBRARIES/UMLPrimitiveTypes.library.uml#String",
                library + "#String"))
        .expect(2)
        .says("changed.uml:17:")
        .says(library);
  }

  @Test
  void profileMustBeWhereTheModelSaysBelowTheGivenFolders() throws IOException {
    Path alone = Files.createDirectories(folder.resolve("alone"));
    Path copy = Files.copy(model, alone.resolve("shop.uml"));
    validate(copy)
        .expect(2)
        .says("[xmi.package.unknown]")
        .says("`persistence.profile.uml` must be its file");
    Files.writeString(
        copy,
        Files.readString(copy).replace("persistence.profile.uml", "../persistence.profile.uml"));
    new Program()
        .run("validate", copy)
        .expect(2)
        .says("[xmi.href.refused]")
        .says("[xmi.package.unknown]");
  }

  @Test
  void metamodelThatIsNoProfileIsNotTakenFromWhereAModelSays() throws IOException {
    Files.writeString(folder.resolve("library.ecore"), AnyMetamodelTest.ECORE);
    Path file =
        Files.writeString(
            folder.resolve("books.xmi"),
            """
            <library:Book xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:library="http://example.org/library" xsi:schemaLocation="http://example.org/library library.ecore#/"/>
            """);
    new Program().run("validate", file).expect(2).says("[xmi.package.unknown]");
  }

  @Test
  void oneEndOfAnAssociationMayBeLeftOut() throws IOException {
    validate(changed(" association=\"_0", " xmi:uuid=\"_0")).expect(1).says("1 error, 0 warnings");
  }

  @Test
  void unknownFeatureIsFoundWithTheOneThatWasMeant() throws IOException {
    validate(changed("<ownedLiteral", "<ownedLteral"))
        .expect(2)
        .says("Class `Enumeration` has no feature `ownedLteral`")
        .says("Did you mean `ownedLiteral`?");
  }

  @Test
  void umlIsDescribedAndNamedByItsNamespace() {
    new Program()
        .run("describe", NAMESPACE)
        .expect(0)
        .says("class Class extends")
        .says("getAppliedStereotypes() : Stereotype [0..*]");
    new Program()
        .run("validate", "--metamodel", NAMESPACE, "--ocl", rules, model)
        .expect(1)
        .says("violates 'Identified'");
    new Program().run("describe", NAMESPACE + "X").expect(2).says("There is no such file");
  }

  /** Compares with what Eclipse UML2 itself reads from the same files. */
  @Test
  void elementsAreThoseThatEclipseUml2Reads() {
    ResourceSet set = UMLResourcesUtil.init(new ResourceSetImpl());
    Resource theirs = set.getResource(URI.createFileURI(model.toString()), true);
    Resource ours = EventChainMetamodel.store(folder).load(model).resource();
    assertEquals(facts(theirs), facts(ours));
    assertEquals(41, facts(ours).size());
  }

  private static List<String> facts(Resource resource) {
    List<String> facts = new ArrayList<>();
    resource.getAllContents().forEachRemaining(each -> facts.add(fact(each)));
    return facts;
  }

  private static String fact(EObject object) {
    StringBuilder fact = new StringBuilder(object.eClass().getName());
    if (object instanceof NamedElement named) {
      fact.append(' ').append(named.getQualifiedName());
    }
    if (object instanceof Property property) {
      fact.append(" : ").append(property.getType().getQualifiedName());
      fact.append(property.getLower()).append("..").append(property.getUpper());
      fact.append(property.getAssociation() == null ? "" : " of an association");
    }
    if (object instanceof Class type) {
      fact.append(names(type.getAllAttributes().stream()));
    }
    if (object instanceof Element element) {
      fact.append(names(element.getAppliedStereotypes().stream()));
    }
    return fact.toString();
  }

  private static String names(Stream<? extends NamedElement> elements) {
    return elements.map(NamedElement::getName).sorted().toList().toString();
  }
}
