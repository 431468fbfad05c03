package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.TestModels;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests cases in which plain Eclipse OCL goes wrong silently. */
class TrapsTest {

  private final TestModels models = new TestModels("library");
  private final EPackage metamodel = models.metamodel();
  private final EObject library = models.load("library.xmi");

  private static EPackage newPackage(String name, EPackage outer, String... classes) {
    EPackage created = EcoreFactory.eINSTANCE.createEPackage();
    created.setName(name);
    created.setNsPrefix(name);
    created.setNsURI((outer == null ? "http://" : outer.getNsURI() + "/") + name);
    for (String each : classes) {
      EClass type = EcoreFactory.eINSTANCE.createEClass();
      type.setName(each);
      created.getEClassifiers().add(type);
    }
    if (outer != null) {
      outer.getESubpackages().add(created);
    }
    return created;
  }

  private OclRules parse(String text, EPackage... packages) {
    return OclRules.parse(List.of(SourceText.of("rules.ocl", text)), List.of(packages));
  }

  private static List<String> said(List<Diagnostic> diagnostics) {
    return diagnostics.stream()
        .map(each -> (each.location() + " " + each.message() + " " + each.hint()).strip())
        .toList();
  }

  @Test
  void documentsWithoutConstraintsAreNamed() {
    for (String text :
        List.of("", "  \r\n", "-- only a comment", "/* x */ context Book def: a : Integer = 1")) {
      OclResult result =
          OclValidator.validate(
              parse(text, metamodel), List.of(library), element -> SourceLocation.NONE);
      assertEquals(
          List.of(
              "rules.ocl Nothing was checked: there is no constraint in rules.ocl."
                  + " Write invariants: context Class inv Name: ..."),
          said(result.diagnostics()),
          text);
    }
    OclRules two =
        OclRules.parse(
            List.of(SourceText.of("a.ocl", ""), SourceText.of("b.ocl", "--")), List.of(metamodel));
    OclResult result = OclValidator.validate(two, List.of(library), element -> SourceLocation.NONE);
    assertEquals(
        "Nothing was checked: there is no constraint in a.ocl, b.ocl.",
        result.diagnostics().get(0).message());
  }

  @Test
  void aFileInUtf16IsRefused(@TempDir Path folder) throws IOException {
    for (var charset : List.of(StandardCharsets.UTF_16, StandardCharsets.UTF_16LE)) {
      Path file = folder.resolve("rules.ocl");
      Files.writeString(file, "\uFEFFcontext Book inv A: true", charset);
      DiagnosticException refused =
          assertThrows(DiagnosticException.class, () -> SourceText.read(file));
      assertEquals("file.encoding", refused.diagnostics().get(0).id());
    }
  }

  @Test
  void placesAreRightAfterAByteOrderMarkAndWithWindowsLineEnds() {
    OclRules rules =
        parse(
            "\uFEFFcontext Book\r\n\tinv A: self.pagse > 3\r\n\tinv B: self.pages >\r\n\r\n",
            metamodel);
    assertEquals(
        """
        rules.ocl:2:14: error: Book has no feature 'pagse'. [ocl.type]
            \tinv A: self.pagse > 3
            \t            ^
          hint: Did you mean `pages`?
        rules.ocl:3:20: error: An expression is expected after '>'. [ocl.syntax]
            \tinv B: self.pages >
            \t                  ^
        """,
        DiagnosticFormat.TEXT.render(rules.diagnostics()));
  }

  @Test
  void classesInDeepPackagesAreFoundByTheEndOfTheirNames() {
    EPackage a = newPackage("a", null, "C");
    newPackage("c", newPackage("b", a, "C", "D"), "C");
    OclRules rules =
        parse(
            """
            context a::b::c::C inv One: C.allInstances()->isEmpty() and b::D.allInstances()->isEmpty()
            context b::C inv Two: true
            context a::C inv Three: true
            context D inv Four: a::b::c::C.allInstances()->isEmpty()
            context C inv Five: true
            package a::b::c context C inv Six: true endpackage
            package c context C inv Seven: true endpackage
            """,
            a);
    assertEquals(
        List.of("C::One", "C::Two", "C::Three", "D::Four", "C::Six", "C::Seven"),
        rules.constraintNames());
    assertEquals(
        List.of(
            "rules.ocl:5:9 Several classes are called 'C'. Write one of a::C, a::b::C, a::b::c::C."),
        said(rules.diagnostics()));
  }

  @Test
  void packagesOfOneNameAreAmbiguousUnlessTheWholeNameIsGiven() {
    EPackage one = newPackage("one", null);
    newPackage("x", one, "C");
    EPackage two = newPackage("two", null);
    newPackage("x", two, "C");
    EPackage three = newPackage("three", null, "E");
    String text =
        """
        package x context C inv A: true endpackage
        package one::x context C inv B: true endpackage
        context two::x::C inv D: x::C.allInstances()->isEmpty()
        context E inv F: x::C.allInstances()->isEmpty()
        """;
    OclRules rules = parse(text, one, two, three);
    // From inside a package, a name means the nearest element.
    assertEquals(List.of("C::B", "C::D"), rules.constraintNames());
    assertEquals(
        List.of(
            "rules.ocl:1:9 Several packages are called 'x'. Write one of one::x, two::x.",
            "rules.ocl:4:21 Several types are called 'x::C': one::x::C, two::x::C."),
        said(rules.diagnostics()));
  }

  @Test
  void nothingIsLeftInTheRegistryOfThisProgram() {
    List<String> before = new ArrayList<>(EPackage.Registry.INSTANCE.keySet());
    assertEquals(List.of(), parse("context Book inv A: pages >= 0", metamodel).diagnostics());
    assertEquals(before, new ArrayList<>(EPackage.Registry.INSTANCE.keySet()));
    assertFalse(EPackage.Registry.INSTANCE.containsKey(metamodel.getNsURI()));
    assertEquals(EcorePackage.eINSTANCE, EPackage.Registry.INSTANCE.get(EcorePackage.eNS_URI));
  }
}
