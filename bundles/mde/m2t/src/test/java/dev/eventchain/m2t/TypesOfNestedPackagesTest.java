package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;
import org.junit.jupiter.api.Test;

/** Modules name nested packages by their URI, and types that several packages have, as Acceleo. */
class TypesOfNestedPackagesTest {

  private static final String MODULE =
      """
      [module t(%s)]
      [template public main(p : Part)]
      [comment @main /]
      [file ('out.txt')]
      [for (each : Part | p.eContents())][each.eClass().ePackage.name/];[/for]
      [/file]
      [/template]
      """;

  private final EPackage shop = of("shop", "http://shop");
  private final EPackage archive = of("archive", "http://shop/archive");

  TypesOfNestedPackagesTest() {
    shop.getESubpackages().add(archive);
    EReference parts = EcoreFactory.eINSTANCE.createEReference();
    parts.setName("parts");
    parts.setUpperBound(-1);
    parts.setContainment(true);
    parts.setEType(EcorePackage.Literals.EOBJECT);
    ((EClass) shop.getEClassifiers().get(0)).getEStructuralFeatures().add(parts);
  }

  private static EPackage of(String name, String uri) {
    EPackage made = EcoreFactory.eINSTANCE.createEPackage();
    made.setName(name);
    made.setNsPrefix(name);
    made.setNsURI(uri);
    EClass type = EcoreFactory.eINSTANCE.createEClass();
    type.setName("Part");
    made.getEClassifiers().add(type);
    return made;
  }

  private static EObject part(EPackage of) {
    return of.getEFactoryInstance().create((EClass) of.getEClassifiers().get(0));
  }

  private String generate(String uris) {
    EObject whole = part(shop);
    @SuppressWarnings("unchecked")
    List<EObject> parts = (List<EObject>) whole.eGet(whole.eClass().getEStructuralFeature("parts"));
    parts.addAll(List.of(part(shop), part(archive)));
    TemplateModule module =
        TemplateModule.compile(
            SourceText.of("t.mtl", MODULE.formatted(uris)),
            name -> Optional.empty(),
            List.of(shop));
    byte[] text =
        module.generate(List.of(whole), any -> SourceLocation.of("m.xmi")).files().get("out.txt");
    return new String(text, UTF_8);
  }

  @Test
  void aNameOfTypesInSeveralPackagesIsThatOfTheOuterOne() {
    assertEquals("shop;\n", generate("'http://shop'"));
  }

  @Test
  void aModuleMayNameANestedPackage() {
    assertEquals("shop;\n", generate("'http://shop', 'http://shop/archive'"));
  }

  @Test
  void aPackageThatThereIsNotIsNamedWithThoseThereAre() {
    DiagnosticException found =
        assertThrows(DiagnosticException.class, () -> generate("'http://shop', 'http://none'"));
    String hint = found.diagnostics().get(0).hint();
    assertTrue(hint.contains("http://shop, http://shop/archive"), hint);
  }
}
