package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
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

  @TempDir Path folder;
  private UmlCase uml;

  @BeforeEach
  void copy() throws IOException {
    uml = UmlCase.in(folder);
  }

  @Test
  void templateReadsDerivedFeaturesAndStereotypes() throws IOException {
    Path out = folder.resolve("out");
    new Program()
        .run("generate", "--template", folder.resolve("java.mtl"), uml.model(), "-o", out)
        .expect(0)
        .says("3 written");
    Path expected = UmlCase.FILES.resolve("expected/shop/domain");
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
    new Program().run("generate", "--template", template, uml.model(), "-o", out).expect(0);
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
        .run("validate", "--metamodel", profile, uml.model())
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
    uml.validate(uml.model())
        .expect(1)
        .says("shop.uml:12:7: error: Class 'Customer' violates 'Identified'")
        .says("1 error, 0 warnings");
    uml.validate(uml.changed("name=\"Order\"", "name=\"order\""))
        .expect(1)
        .says("violates 'Capital'");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "pathmap://UML_LIBRARIES/Nothing.library.uml",
        "pathmap://UML_LIBRARIES/../../secret.library.uml",
        "pathmap://OTHER/UMLPrimitiveTypes.library.uml",
      })
  void libraryThatDoesNotExistIsAFinding(String library) throws IOException {
    uml.validate(
            uml.changed(
                "pathmap://UML_LIBRARIES/UMLPrimitiveTypes.library.uml#String",
                library + "#String"))
        .expect(2)
        .says("changed.uml:17:")
        .says(library);
  }

  @Test
  void profileMustBeWhereTheModelSaysBelowTheGivenFolders() throws IOException {
    Path alone = Files.createDirectories(folder.resolve("alone"));
    Path copy = Files.copy(uml.model(), alone.resolve("shop.uml"));
    uml.validate(copy)
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
    uml.validate(uml.changed(" association=\"_0", " xmi:uuid=\"_0"))
        .expect(1)
        .says("1 error, 0 warnings");
    uml.validate(uml.changed(" memberEnd=\"_", " xmi:uuid=\"_"))
        .expect(1)
        .says("1 error, 0 warnings");
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
    Path file = uml.changed(" table=\"CUSTOMERS\"", "");
    Path out = folder.resolve("out");
    new Program().run("generate", "--template", folder.resolve("java.mtl"), file, "-o", out);
    new Program().run("diagram", file, "-o", folder.resolve("diagram"));
    uml.validate(file);
    assertTrue(Files.exists(out.resolve("shop/domain/Customer.java")));
    assertTrue(Files.notExists(victim), "the profile wrote a file");
  }

  @Test
  void profilesThatNameEachOtherEndlesslyAreRefused() throws IOException {
    String head = Files.readString(uml.model()).replaceFirst("(?s)<uml:Model.*", "");
    for (int i = 0; i < 40; i++) {
      Files.writeString(
          folder.resolve("p" + i + ".uml"),
          head.replace("persistence.profile.uml", "p" + (i + 1) + ".uml")
              + "<Persistence:Key xmi:id=\"_k\"/></xmi:XMI>");
    }
    uml.validate(folder.resolve("p0.uml")).expect(2).says("[xmi.package.unknown]");
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
    uml.validate(uml.changed(typed, "<type href=\"" + href + "\"/>")).expect(code).says(says);
  }

  @Test
  void chainBesideAUmlModelIsCheckedAsAChain() throws IOException {
    Path chain =
        Files.writeString(
            folder.resolve("chain.xmi"),
            Files.readString(Program.ROOT.resolve("examples/radar-aeb/model/chain.xmi"))
                .replaceFirst("messageType=\"[^\"]*\"", "messageType=\"nowhere_msgs/msg/No\""));
    new Program().run("validate", chain, uml.model()).expect(1).says("nowhere_msgs");
  }

  @Test
  void expressionsDoNotChangeTheModel() throws IOException {
    Files.writeString(
        uml.rules(),
        """
        package uml
        context Class
        inv Destroys: self.ownedAttribute->forAll(p | p.destroy() = null)
        inv HasNone: self.ownedAttribute->isEmpty()
        endpackage
        """);
    uml.validate(uml.model()).expect(1).says("changes the model").says("violates 'HasNone'");
  }

  @Test
  void contradictionOfTwoEndsIsFound() throws IOException {
    String other = "<packagedElement xmi:type=\"uml:Association\" xmi:id=\"_other\" memberEnd=\"_";
    Path file =
        uml.changed(
            "<packagedElement xmi:type=\"uml:Enumeration\"",
            other
                + memberEnds().replace(" ", " _")
                + "\"/><packagedElement xmi:type=\"uml:Enumeration\"");
    uml.validate(file).expect(1).says("[ecore.opposite]");
  }

  private String memberEnds() throws IOException {
    String text = Files.readString(uml.model());
    return text.replaceFirst("(?s).*memberEnd=\"_([^ ]*) _([^\"]*)\".*", "$1 $2");
  }

  @Test
  void unknownFeatureIsFoundWithTheOneThatWasMeant() throws IOException {
    uml.validate(uml.changed("<ownedLiteral", "<ownedLteral"))
        .expect(2)
        .says("Class `Enumeration` has no feature `ownedLteral`")
        .says("Did you mean `ownedLiteral`?");
  }

  @Test
  void umlIsDescribedAndNamedByItsNamespace() {
    new Program()
        .run("describe", UmlCase.NAMESPACE)
        .expect(0)
        .says("class Class extends")
        .says("getAppliedStereotypes() : Stereotype [0..*]");
    new Program()
        .run("validate", "--metamodel", UmlCase.NAMESPACE, "--ocl", uml.rules(), uml.model())
        .expect(1)
        .says("violates 'Identified'");
    new Program().run("describe", UmlCase.NAMESPACE + "X").expect(2).says("Known by their nsURI");
  }
}
