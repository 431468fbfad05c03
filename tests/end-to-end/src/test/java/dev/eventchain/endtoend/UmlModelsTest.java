package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.Projects;
import dev.eventchain.model.EventChainMetamodel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.ResourceSet;
import org.eclipse.emf.ecore.resource.impl.ResourceSetImpl;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.uml2.uml.resources.util.UMLResourcesUtil;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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

  private Path aboutStereotypes(String name, String feature) throws IOException {
    return Files.writeString(
        Files.createDirectories(folder.resolve(name).getParent()).resolve("entities.mtl"),
        """
        [comment encoding = UTF-8 /]
        [module entities('http://www.eclipse.org/uml2/5.0.0/UML', 'http:///schemas/Persistence/_005/0')/]
        [template public generate(e : Entity)]
        [comment @main /]
        [file (e.base_Class.name + '.txt', false, 'UTF-8')]
        [e.%s/] [e.cached/]
        [/file]
        [/template]
        """
            .formatted(feature));
  }

  @Test
  void stereotypesAreTypesOfTemplatesWithAndWithoutAModel() throws IOException {
    Path template = aboutStereotypes("entities.mtl", "table");
    Path out = folder.resolve("out");
    new Program().run("generate", "--template", template, model, "-o", out).expect(0);
    assertEquals("CUSTOMERS false\n", Files.readString(out.resolve("Customer.txt")));
    new Program().run("compile", template).expect(0).says("0 errors, 0 warnings in 1 file");
    new Program()
        .run("compile", aboutStereotypes("entities.mtl", "tabel"))
        .expect(1)
        .says("entities.mtl:6:4: error: Entity has no feature 'tabel'.")
        .says("Did you mean `table`?");
  }

  @Test
  void profileOfATemplateIsBesideItOrNamed() throws IOException {
    Path template = aboutStereotypes("templates/entities.mtl", "table");
    Path profile = folder.resolve("persistence.profile.uml");
    new Program().run("compile", template).expect(1).says("[m2t.metamodel.unknown]");
    new Program().run("compile", "--metamodel", profile, template).expect(0).says("0 errors");
    new Program().run("describe", profile).expect(0).says("class Entity").says("table : String");
    new Program()
        .run("validate", "--metamodel", profile, model)
        .expect(2)
        .says("It is a profile of UML, which is found where a model applies it");
    Path unsound = template.resolveSibling("own.profile.uml");
    Files.writeString(unsound, Files.readString(profile).replace("<ownedAttribute", "<ownAttr"));
    new Program()
        .run("compile", template)
        .expect(1)
        .says("[m2t.metamodel.unknown]")
        .says("own.profile.uml:");
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

  @ParameterizedTest
  @ValueSource(strings = {"2.1.0", "3.0.0"})
  void featureOfAnOlderVersionIsFoundWithTheVersionOfTheFile(String version) throws IOException {
    Path file = changed("xmlns:uml=\"" + NAMESPACE, "xmlns:uml=\"" + older(version));
    Files.writeString(file, Files.readString(file).replaceFirst("<ownedLiteral", "<oldLiteral"));
    validate(file)
        .expect(2)
        .says("Class `Enumeration` has no feature `oldLiteral`.")
        .says(
            "The file is of Eclipse UML2 "
                + version
                + ", and UML 2.5 is read here: open and save it");
    Program.Ended current = validate(changed("<ownedLiteral", "<oldLiteral")).expect(2);
    assertFalse((current.out() + current.err()).contains("and save it"));
  }

  private static String older(String version) {
    return NAMESPACE.replace("5.0.0", version);
  }

  @Test
  void firstVersionOfUml2IsFoundWithWhatConvertsIt() throws IOException {
    validate(changed("xmlns:uml=\"" + NAMESPACE, "xmlns:uml=\"" + older("1.0.0")))
        .expect(2)
        .says("[xmi.package.unknown]")
        .says("The file is of Eclipse UML2 1.0.0, and UML 2.5 is read here: open and save it");
  }

  @Test
  void metamodelOfTheOmgIsFoundWithWhatIsBuiltIn() throws IOException {
    String head =
        "<xmi:XMI xmlns:xmi=\"http://www.omg.org/spec/XMI/20131001\""
            + " xmlns:uml=\"http://www.omg.org/spec/UML/20131001\""
            + " xmlns:mofext=\"http://www.omg.org/spec/MOF/20131001\">"
            + "<uml:Package xmi:type=\"uml:Package\" xmi:id=\"_0\" name=\"UML\"/>";
    Path cmof =
        Files.writeString(
            folder.resolve("UML.xmi"),
            head + "<mofext:Tag xmi:type=\"mofext:Tag\" xmi:id=\"_1\" element=\"_0\"/></xmi:XMI>");
    String builtIn = "That of UML is built in, as " + NAMESPACE;
    new Program().run("validate", "--metamodel", cmof, model).expect(2).says(builtIn);
    Files.writeString(cmof, head + "</xmi:XMI>");
    new Program()
        .run("describe", cmof)
        .expect(2)
        .says("It is a model of UML: name it as a model. The metamodel of UML is built in");
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
    validate(changed(" memberEnd=\"_", " xmi:uuid=\"_")).expect(1).says("1 error, 0 warnings");
  }

  @Test
  void standardProfileOfOlderVersionsIsTheStandardProfile() throws IOException {
    Files.writeString(
        folder.resolve("standard.uml"),
        """
        <xmi:XMI xmi:version="2.1" xmlns:xmi="http://schema.omg.org/spec/XMI/2.1" xmlns:uml="http://www.eclipse.org/uml2/4.0.0/UML" xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" xmlns:s="http://www.eclipse.org/uml2/4.0.0/UML/Profile/L2">
          <uml:Model xmi:id="m" name="m">
            <packagedElement xmi:type="uml:Class" xmi:id="c" name="C"/>
            <profileApplication xmi:id="p">
              <eAnnotations xmi:id="e" source="http://www.eclipse.org/uml2/2.0.0/UML">
                <references xmi:type="ecore:EPackage" href="http://www.eclipse.org/uml2/4.0.0/UML/Profile/L2#/"/>
              </eAnnotations>
              <appliedProfile href="pathmap://UML_PROFILES/StandardL2.profile.uml#_0"/>
            </profileApplication>
          </uml:Model>
          <s:Utility xmi:id="u" base_Class="c"/>
        </xmi:XMI>
        """);
    Path ocl =
        Files.writeString(
            folder.resolve("utility.ocl"),
            """
            package uml
            context Class
            inv NoUtility: self.getAppliedStereotypes()->forAll(name <> 'Utility')
            endpackage
            """);
    new Program()
        .run("validate", "--ocl", ocl, folder.resolve("standard.uml"))
        .expect(1)
        .says("Class 'C' violates 'NoUtility'");
  }

  /** A default value is made by the constructor of the Java class that a data type names. */
  @Test
  void profileRunsNoCodeThatItNames() throws IOException {
    Path victim = folder.resolve("victim");
    Path profile = folder.resolve("persistence.profile.uml");
    String text = Files.readString(profile);
    String attribute = "name=\"table\" ordered=\"false\">";
    assertTrue(text.contains(attribute), text);
    Files.writeString(
        profile,
        text.replaceFirst(
                "(?s)(<eStructuralFeatures[^>]*name=\"table\") ordered=\"false\">.*?</eStructuralFeatures>",
                "$1 eType=\"_evil\" defaultValueLiteral=\"" + victim + "\"/>")
            .replaceFirst(
                "<eClassifiers ",
                "<eClassifiers xmi:type=\"ecore:EDataType\" xmi:id=\"_evil\" name=\"Evil\""
                    + " instanceClassName=\"java.io.FileOutputStream\"/><eClassifiers "));
    Path file = changed(" table=\"CUSTOMERS\"", "");
    Path out = folder.resolve("out");
    new Program().run("generate", "--template", folder.resolve("java.mtl"), file, "-o", out);
    new Program().run("diagram", file, "-o", folder.resolve("diagram"));
    validate(file);
    assertTrue(Files.exists(out.resolve("shop/domain/Customer.java")));
    assertTrue(Files.notExists(victim), "the profile wrote a file");
  }

  @Test
  void profilesThatNameEachOtherEndlesslyAreRefused() throws IOException {
    String head = Files.readString(model).replaceFirst("(?s)<uml:Model.*", "");
    for (int i = 0; i < 40; i++) {
      Files.writeString(
          folder.resolve("p" + i + ".uml"),
          head.replace("persistence.profile.uml", "p" + (i + 1) + ".uml")
              + "<Persistence:Key xmi:id=\"_k\"/></xmi:XMI>");
    }
    validate(folder.resolve("p0.uml")).expect(2).says("[xmi.package.unknown]");
  }

  @ParameterizedTest
  @CsvSource({
    "http://www.omg.org/spec/UML/20131001/PrimitiveTypes.xmi#String, 1, violates 'Identified'",
    "missing.uml#x, 2, names a file that does not exist",
    "../../../etc/passwd#x, 2, leaves the folders",
    "shop.uml#nothing, 2, names no element",
  })
  void referenceWithoutATypeIsResolved(String href, int code, String says) throws IOException {
    String typed =
        "<type xmi:type=\"uml:PrimitiveType\" href=\"pathmap://UML_LIBRARIES/UMLPrimitiveTypes.library.uml#String\"/>";
    validate(changed(typed, "<type href=\"" + href + "\"/>")).expect(code).says(says);
  }

  @Test
  void metaclassesOfTheOmgAreThoseOfTheMetamodel() throws IOException {
    Path file =
        changed(
            "<profileApplication",
            "<elementImport xmi:id=\"_i\"><importedElement xmi:type=\"uml:Class\""
                + " href=\"http://schema.omg.org/spec/UML/2.2/uml.xml#Class\"/></elementImport>"
                + "<profileApplication");
    validate(file).expect(1).says("1 error, 0 warnings");
  }

  @Test
  void chainBesideAUmlModelIsCheckedAsAChain() throws IOException {
    Path chain =
        Files.writeString(
            folder.resolve("chain.xmi"),
            Files.readString(Program.ROOT.resolve("examples/radar-aeb/model/chain.xmi"))
                .replaceFirst("messageType=\"[^\"]*\"", "messageType=\"nowhere_msgs/msg/No\""));
    new Program().run("validate", chain, model).expect(1).says("nowhere_msgs");
  }

  @Test
  void expressionsDoNotChangeTheModel() throws IOException {
    Files.writeString(
        rules,
        """
        package uml
        context Class
        inv Destroys: self.ownedAttribute->forAll(p | p.destroy() = null)
        inv HasNone: self.ownedAttribute->isEmpty()
        endpackage
        """);
    validate(model).expect(1).says("changes the model").says("violates 'HasNone'");
  }

  @Test
  void contradictionOfTwoEndsIsFound() throws IOException {
    String other = "<packagedElement xmi:type=\"uml:Association\" xmi:id=\"_other\" memberEnd=\"_";
    Path file =
        changed(
            "<packagedElement xmi:type=\"uml:Enumeration\"",
            other
                + memberEnds().replace(" ", " _")
                + "\"/><packagedElement xmi:type=\"uml:Enumeration\"");
    validate(file).expect(1).says("[ecore.opposite]");
  }

  private String memberEnds() throws IOException {
    String text = Files.readString(model);
    return text.replaceFirst("(?s).*memberEnd=\"_([^ ]*) _([^\"]*)\".*", "$1 $2");
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
    new Program().run("describe", NAMESPACE + "X").expect(2).says("Known by their nsURI");
  }

  /** Compares every value, also of derived features, with what Eclipse UML2 itself reads. */
  @ParameterizedTest
  @CsvSource({"shop.uml, 41", "behaviour.uml, 18"})
  void valuesAreThoseThatEclipseUml2Reads(String name, int elements) {
    Path file = folder.resolve(name);
    ResourceSet set = UMLResourcesUtil.init(new ResourceSetImpl());
    Resource theirs = set.getResource(URI.createFileURI(file.toString()), true);
    Resource ours = EventChainMetamodel.store(folder).load(file).resource();
    EcoreUtil.resolveAll(set);
    SortedMap<String, String> expected = values(theirs);
    assertEquals(elements, expected.keySet().stream().map(UmlModelsTest::owner).distinct().count());
    assertEquals(text(expected), text(values(ours)));
  }

  private static String owner(String feature) {
    return feature.replaceFirst(" .*", "");
  }

  private static String text(SortedMap<String, String> values) {
    StringBuilder text = new StringBuilder();
    values.forEach((feature, value) -> text.append(feature).append('=').append(value).append('\n'));
    return text.toString();
  }

  private static SortedMap<String, String> values(Resource resource) {
    SortedMap<String, String> values = new TreeMap<>();
    resource
        .getAllContents()
        .forEachRemaining(
            element -> {
              for (EStructuralFeature feature : element.eClass().getEAllStructuralFeatures()) {
                value(element, feature)
                    .ifPresent(value -> values.put(name(element) + " " + feature.getName(), value));
              }
            });
    return values;
  }

  /** Returns the value of a feature; empty for one that UML2 does not compute. */
  private static Optional<String> value(EObject element, EStructuralFeature feature) {
    try {
      return Optional.of(shown(element.eGet(feature)));
    } catch (UnsupportedOperationException e) {
      return Optional.empty();
    }
  }

  private static String shown(Object value) {
    if (value instanceof Collection<?> values) {
      return values.stream().map(UmlModelsTest::shown).toList().toString();
    }
    return value instanceof EObject element ? name(element) : String.valueOf(value);
  }

  private static String name(EObject element) {
    URI uri = EcoreUtil.getURI(element);
    return uri.trimFragment().lastSegment() + "#" + uri.fragment();
  }
}
