package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.List;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.junit.jupiter.api.Test;

/** Metamodels that the given one refers to: their constraints hold for its models, too. */
class ReferredMetamodelsTest {

  private static final EcoreFactory FACTORY = EcoreFactory.eINSTANCE;

  private final EPackage base = newPackage("base");
  private final EClass named = newClass(base, "Named");
  private final EPackage shop = newPackage("shop");
  private final EClass item = newClass(shop, "Item");

  ReferredMetamodelsTest() {
    EAttribute name = FACTORY.createEAttribute();
    name.setName("name");
    name.setEType(EcorePackage.Literals.ESTRING);
    named.getEStructuralFeatures().add(name);
    item.getESuperTypes().add(named);
    EcoreUtil.setAnnotation(
        named, "http://www.eclipse.org/emf/2002/Ecore/OCL", "HasName", "name <> null");
  }

  private static EPackage newPackage(String name) {
    EPackage created = FACTORY.createEPackage();
    created.setName(name);
    created.setNsURI("http://example.org/" + name);
    return created;
  }

  private static EClass newClass(EPackage owner, String name) {
    EClass created = FACTORY.createEClass();
    created.setName(name);
    owner.getEClassifiers().add(created);
    return created;
  }

  private OclRules rules(String... documents) {
    List<SourceText> texts =
        List.of(documents).stream().map(t -> SourceText.of("r.ocl", t)).toList();
    return OclRules.parse(texts, List.of(shop), element -> SourceLocation.of("m.ecore"));
  }

  @Test
  void constraintsOfAReferredMetamodelAreEvaluated() {
    EObject unnamed = EcoreUtil.create(item);
    List<Diagnostic> found =
        OclValidator.validate(rules(), List.of(unnamed), element -> SourceLocation.of("m.xmi"))
            .diagnostics();
    assertEquals(List.of("Named::HasName"), found.stream().map(Diagnostic::rule).toList());
  }

  @Test
  void documentsMayNameItsClasses() {
    OclRules rules =
        rules("context Named inv Short: name.size() < 10\ncontext base::Named inv A: true");
    assertEquals(List.of(), rules.diagnostics());
    assertEquals(List.of("Named::HasName", "Named::Short", "Named::A"), rules.constraintNames());
  }

  @Test
  void classOfTheGivenMetamodelGoesFirst() {
    newClass(base, "Item");
    OclRules rules = rules("context Item inv A: name <> ''");
    assertEquals(List.of(), rules.diagnostics());
    assertEquals(item, rules.constraint("Item::A").orElseThrow().context());
  }

  @Test
  void metamodelThatOnlyAParameterNamesIsReferredTo() {
    EPackage other = newPackage("other");
    EClass shelf = newClass(other, "Shelf");
    EOperation put = FACTORY.createEOperation();
    put.setName("put");
    EParameter on = FACTORY.createEParameter();
    on.setName("on");
    on.setEType(shelf);
    put.getEParameters().add(on);
    item.getEOperations().add(put);
    OclRules rules = rules("context Shelf inv A: true");
    assertEquals(List.of(), rules.diagnostics());
  }
}
