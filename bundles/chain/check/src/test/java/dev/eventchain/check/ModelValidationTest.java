package dev.eventchain.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Validates models of any metamodel against it and against constraints. */
class ModelValidationTest {

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

  @TempDir Path folder;

  @BeforeEach
  void write() throws IOException {
    Files.writeString(folder.resolve("shop.ecore"), ECORE);
    Files.writeString(folder.resolve("bakery.xmi"), shop("bakery", "anna.xmi"));
    Files.writeString(folder.resolve("anna.xmi"), person("Anna"));
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

  private Validation validate(List<Path> constraints, String... models) {
    return ModelValidation.validate(
        ModelFiles.of(
            List.of(models).stream().map(folder::resolve).toList(),
            List.of(folder.resolve("shop.ecore"))),
        constraints,
        List.of(),
        Duration.ofMinutes(1));
  }

  private static List<String> ids(List<Diagnostic> found) {
    return found.stream().map(Diagnostic::id).toList();
  }

  /** Makes the owner of a shop, and the name of a person, required. */
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
  void whatAMetamodelDemandsIsCheckedWithoutConstraints() throws IOException {
    demand();
    Validation fine = validate(List.of(), "bakery.xmi");
    assertEquals(List.of(), fine.diagnostics());
    assertEquals(2, fine.coverage().evaluations(Coverage.Kind.METAMODEL));
    Files.writeString(
        folder.resolve("bakery.xmi"), shop("bakery", "anna.xmi").replaceAll("<owner.*/>", ""));
    assertEquals(List.of("ecore.required"), ids(validate(List.of(), "bakery.xmi").diagnostics()));
  }

  @Test
  void nothingDemandedAndNoConstraintIsNoPass() {
    assertEquals(
        List.of("ocl.nothing-evaluated"), ids(validate(List.of(), "bakery.xmi").diagnostics()));
  }

  @Test
  void aModelThatNoConstraintIsAboutIsNamedBesideOthers() throws IOException {
    demand();
    Path people =
        Files.writeString(folder.resolve("rules.ocl"), "context Shop inv Named: name <> ''\n");
    Validation found = validate(List.of(people), "bakery.xmi", "anna.xmi");
    assertEquals(List.of("ocl.model-unconstrained"), ids(found.diagnostics()));
    assertTrue(found.diagnostics().get(0).location().file().endsWith("anna.xmi"));
    Path values =
        Files.writeString(
            folder.resolve("values.ocl"),
            "package ecore context EString inv Named: self <> '' endpackage\n");
    assertEquals(
        List.of(), ids(validate(List.of(people, values), "bakery.xmi", "anna.xmi").diagnostics()));
  }

  /** Both files are named, and all of the second one is a part of the first. */
  @Test
  void aModelWhoseRootIsPartOfAnotherFileIsConstrainedThere() throws IOException {
    Files.writeString(
        folder.resolve("shop.ecore"),
        ECORE.replace(
            "name=\"owner\"", "name=\"owner\" containment=\"true\" resolveProxies=\"false\""));
    Path ocl =
        Files.writeString(folder.resolve("rules.ocl"), "context Shop inv Named: name <> ''\n");
    Validation found = validate(List.of(ocl), "bakery.xmi", "anna.xmi");
    assertEquals(List.of(), ids(found.diagnostics()));
  }

  @Test
  void filesThatAModelRefersToAreValidatedToo() throws IOException {
    demand();
    Files.writeString(folder.resolve("anna.xmi"), person("Anna").replace("name=", "xmi:id="));
    Path ocl =
        Files.writeString(
            folder.resolve("rules.ocl"), "context Person inv Named: self.name <> null\n");
    Validation found = validate(List.of(ocl), "bakery.xmi");
    assertEquals(
        List.of("ocl.violated", "ocl.model-unconstrained", "ecore.required"),
        ids(found.diagnostics()));
    assertEquals(2, found.coverage().elements());
    assertEquals(4, found.coverage().files().size());
    assertTrue(found.diagnostics().get(0).location().file().endsWith("anna.xmi"));
  }

  /** The vehicle is unknown, so its publishers and subscribers are not checked. */
  @Test
  void anEventChainNeedsNoMetamodelAndItsContractsAreChecked() {
    ProjectCopy radar = new ProjectCopy(ProjectCopy.RADAR);
    Validation fine =
        ModelValidation.validate(
            ModelFiles.of(List.of(radar.file("model/chain.xmi")), List.of()),
            List.of(),
            List.of(radar.file("software-base/msg")),
            Duration.ofMinutes(1));
    assertEquals(List.of(), fine.diagnostics());
    assertTrue(fine.coverage().evaluations(Coverage.Kind.CONTRACT) > 0);
    assertTrue(fine.coverage().evaluations(Coverage.Kind.CONSTRAINT) > 0);
  }
}
