package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests models of other versions of UML, of Eclipse UML2 and of the OMG. */
class UmlVersionsTest {

  @TempDir Path folder;
  private UmlCase uml;

  @BeforeEach
  void copy() throws IOException {
    uml = UmlCase.in(folder);
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
    uml.validate(uml.changed("xmlns:uml=\"" + UmlCase.NAMESPACE, "xmlns:uml=\"" + namespace))
        .expect(1)
        .says("violates 'Identified'")
        .says("1 error, 0 warnings");
  }

  @ParameterizedTest
  @ValueSource(strings = {"2.1.0", "3.0.0"})
  void featureOfAnOlderVersionIsFoundWithTheVersionOfTheFile(String version) throws IOException {
    Path file = uml.changed("xmlns:uml=\"" + UmlCase.NAMESPACE, "xmlns:uml=\"" + older(version));
    Files.writeString(file, Files.readString(file).replaceFirst("<ownedLiteral", "<oldLiteral"));
    uml.validate(file)
        .expect(2)
        .says("Class `Enumeration` has no feature `oldLiteral`.")
        .says(
            "The file is of Eclipse UML2 "
                + version
                + ", and UML 2.5 is read here: open and save it");
    Program.Ended current = uml.validate(uml.changed("<ownedLiteral", "<oldLiteral")).expect(2);
    assertFalse((current.out() + current.err()).contains("and save it"));
  }

  private static String older(String version) {
    return UmlCase.NAMESPACE.replace("5.0.0", version);
  }

  @Test
  void firstVersionOfUml2IsFoundWithWhatConvertsIt() throws IOException {
    uml.validate(uml.changed("xmlns:uml=\"" + UmlCase.NAMESPACE, "xmlns:uml=\"" + older("1.0.0")))
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
    String builtIn = "That of UML is built in, as " + UmlCase.NAMESPACE;
    new Program().run("validate", "--metamodel", cmof, uml.model()).expect(2).says(builtIn);
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
        uml.changed(
            "pathmap://UML_LIBRARIES/UMLPrimitiveTypes.library.uml",
            "http://www.omg.org/spec/UML/20131001/PrimitiveTypes.xmi");
    new Program()
        .run("generate", "--template", folder.resolve("java.mtl"), file, "-o", out)
        .expect(0);
    assertTrue(
        Files.readString(out.resolve("shop/domain/Item.java")).contains("private Integer id;"));
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

  @Test
  void metaclassesOfTheOmgAreThoseOfTheMetamodel() throws IOException {
    Path file =
        uml.changed(
            "<profileApplication",
            "<elementImport xmi:id=\"_i\"><importedElement xmi:type=\"uml:Class\""
                + " href=\"http://schema.omg.org/spec/UML/2.2/uml.xml#Class\"/></elementImport>"
                + "<profileApplication");
    uml.validate(file).expect(1).says("1 error, 0 warnings");
  }
}
