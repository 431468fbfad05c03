package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import dev.eventchain.ocl.Evaluations;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.metamodel.Names;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EModelElement;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.junit.jupiter.api.Test;

/** Tests annotations of metamodels: invariants, messages, bodies and derivations. */
class MetamodelRulesTest {

  private static final String OCL = "http://www.eclipse.org/emf/2002/Ecore/OCL";

  private static final SourceLocation PLACE = SourceLocation.of("model.xmi");

  private final TestModels models = new TestModels("annotated");
  private final EPackage metamodel = models.metamodel();

  private OclRules rules(String... documents) {
    List<SourceText> texts =
        Stream.of(documents).map(text -> SourceText.of("r.ocl", text)).toList();
    return OclRules.parse(
        texts,
        List.of(metamodel),
        element -> SourceLocation.of("metamodel.ecore").withElement(Names.pathOf(element)));
  }

  private List<String> found(OclRules rules, String model) {
    return OclValidator.validate(
            rules,
            List.of(models.load(model)),
            element -> SourceLocation.of(model).withElement(Names.pathOf(element)))
        .diagnostics()
        .stream()
        .filter(each -> !each.id().equals("ocl.java.missing"))
        .map(each -> each.rule() + ": " + each.message())
        .toList();
  }

  private EClass type(String name) {
    return (EClass) metamodel.getEClassifier(name);
  }

  private static void annotate(EModelElement element, String key, String text) {
    EcoreUtil.setAnnotation(element, OCL + "/Pivot", key, text);
  }

  @Test
  void invariantsOfAllDialectsAreEvaluatedWithTheirMessages() {
    OclRules rules = rules();
    assertEquals(
        List.of(
            "Shop::HasItems", "Item::PositivePrice", "Item::Named", "Item::Cheap", "Item::Doubled"),
        rules.constraintNames());
    assertEquals(
        List.of("Item::Named: An item of 3.0 has no name", "Item::Cheap: 'Cheap'"),
        found(rules, "model.xmi").stream()
            .map(each -> each.startsWith("Item::Cheap") ? "Item::Cheap: 'Cheap'" : each)
            .sorted(Comparator.reverseOrder())
            .toList());
    assertEquals(
        List.of("Shop::HasItems: The shop corner sells nothing"), found(rules, "empty.xmi"));
  }

  @Test
  void constraintThatOnlyJavaKnowsIsSaidNotToBeChecked() {
    Diagnostic said = rules().diagnostics().get(0);
    assertEquals("ocl.java.missing", said.id());
    assertEquals(Severity.WARNING, said.severity());
    assertEquals(
        "The constraint 'Audited' of Shop is not checked: it is defined only in Java code.",
        said.message());
  }

  @Test
  void derivedFeatureThatOnlyJavaComputesIsNotReadAsZero() {
    OclRules rules = rules("context Item inv Rated: rating = 0");
    Diagnostic said = rules.diagnostics().get(rules.diagnostics().size() - 1);
    assertEquals("ocl.java.missing", said.id());
    assertEquals(Severity.ERROR, said.severity());
    assertEquals(
        List.of(), rules.constraintNames().stream().filter("Item::Rated"::equals).toList());
  }

  @Test
  void bodyOfTheSubclassIsTheOneThatIsCalled() {
    OclRules rules = rules("context Item inv Free: name = 'voucher' implies total() = 0.0");
    assertEquals(
        List.of(),
        found(rules, "model.xmi").stream().filter(each -> each.contains("Free")).toList());
    OclRules labels = rules("context Item inv Label: name = 'voucher' implies label() = 'gift'");
    assertEquals(
        List.of(),
        found(labels, "model.xmi").stream().filter(each -> each.contains("Label")).toList());
  }

  @Test
  void bodyThatIsCalledOnASubclassIsItsOwnOrTheNearestAboveIt() {
    EClass wrapped = EcoreFactory.eINSTANCE.createEClass();
    wrapped.setName("Wrapped");
    wrapped.getESuperTypes().add(type("Gift"));
    metamodel.getEClassifiers().add(wrapped);
    EObject shop = models.load("model.xmi");
    EObject present = EcoreUtil.create(wrapped);
    @SuppressWarnings("unchecked")
    List<EObject> items = (List<EObject>) shop.eGet(type("Shop").getEStructuralFeature("items"));
    items.add(present);
    OclRules rules =
        rules(
            """
            context Item def: kind() : String = 'item'
            context Gift def: kind() : String = 'gift'
            context Gift inv Free: total() = 0.0
            context Wrapped inv Free: self.total() = 0.0 and label() = 'gift' and kind() = 'gift'
            """);
    assertEquals(List.of(), errors(rules));
    List<Diagnostic> found =
        OclValidator.validate(rules, List.of(shop), element -> SourceLocation.of("m"))
            .diagnostics();
    assertEquals(List.of(), found.stream().filter(each -> each.rule().endsWith("::Free")).toList());
  }

  @Test
  void definitionOfTheSubclassIsTheOneThatIsCalledInWhateverOrderTheyStand() {
    String upper = "context Item def: kind(n : Integer) : String = 'item'\n";
    String lower = "context Gift def: kind(n : Integer) : String = 'gift'\n";
    String use =
        "context Item inv Kind: kind(1) = if name = 'voucher' then 'gift' else 'item' endif\n";
    for (String document : List.of(upper + lower + use, use + lower + upper)) {
      OclRules rules = rules(document);
      assertEquals(List.of(), errors(rules));
      assertEquals(
          List.of(),
          found(rules, "model.xmi").stream().filter(each -> each.contains("Kind")).toList());
    }
    assertEquals(1, errors(rules(lower + lower.replace("'gift'", "'present'"))).size());
  }

  private static List<Diagnostic> errors(OclRules rules) {
    return rules.diagnostics().stream().filter(each -> each.severity() == Severity.ERROR).toList();
  }

  @Test
  void documentsComputeOperationsAndFeatures() {
    OclRules rules =
        rules(
            """
            import 'http://www.eclipse.org/emf/2002/Ecore#/'
            context Item::label() : String
              pre Named: name <> null
              post: result <> null
              body: 'item of ' + name
            context Item::rating : Integer
              init: 3
              derive: 5
            context i : Item
              inv Labelled('wrong: ' + i.label()): i.oclIsTypeOf(Gift) or i.name = null
                or i.label() = 'item of ' + name
              inv Rated: i.rating = 5
            context p : Item def: twice : Real = p.price * 2.0
            context Item inv Twice: twice = price + price
            """);
    assertEquals(List.of(), errors(rules));
    assertEquals(
        "3 conditions of operations and initial values not checked: no program runs here.",
        rules.diagnostics().stream()
            .filter(each -> each.id().equals("ocl.condition.unchecked"))
            .findFirst()
            .orElseThrow()
            .message());
    assertEquals(
        List.of(),
        found(rules, "model.xmi").stream()
            .filter(each -> each.matches(".*(Labelled|Rated|Twice).*"))
            .toList());
  }

  @Test
  void memberThatIsNotThereIsFound() {
    OclRules rules =
        rules(
            """
            context Item::lable() : String body: 'x'
            context Item::label(n : Integer) : String body: 'x'
            context Item::prize : Real derive: 1.0
            context Item inv A: true
            """);
    assertEquals(3, errors(rules).size(), () -> errors(rules).toString());
    assertEquals("Did you mean `label`?", errors(rules).get(0).hint());
  }

  @Test
  void whatCannotBeParsedIsAnErrorOnTheMetamodel() {
    annotate(type("Shop"), "Broken", "items.nam->size() > 0");
    EStructuralFeature doubled = type("Item").getEStructuralFeature("doubled");
    annotate(doubled, "derivation", "price.nothing");
    EOperation total = type("Item").getEOperations().get(0);
    annotate(total, "body", "'text'");
    List<Diagnostic> errors = errors(rules());
    assertEquals(3, errors.size(), errors::toString);
    for (Diagnostic error : errors) {
      assertEquals("metamodel.ecore", error.location().file());
    }
  }

  @Test
  void constraintsOfADataTypeAreEvaluatedOnItsValues() {
    EDataType code = EcoreFactory.eINSTANCE.createEDataType();
    code.setName("Code");
    code.setInstanceClass(String.class);
    metamodel.getEClassifiers().add(code);
    annotate(code, "Short", "self.size() < 5");
    EAttribute codes = EcoreFactory.eINSTANCE.createEAttribute();
    codes.setName("codes");
    codes.setEType(code);
    codes.setUpperBound(-1);
    type("Shop").getEStructuralFeatures().add(codes);
    EObject shop = models.load("model.xmi");
    shop.eSet(codes, List.of("ok", "toolong", "fine", "muchlonger"));
    OclResult result =
        OclValidator.validate(
            rules("context Code inv Text: self <> 'fine'"), List.of(shop), element -> PLACE);
    assertEquals(
        List.of(
            "codes 'fine' of Shop 'corner' violates 'Text'.",
            "codes 'muchlonger' of Shop 'corner' violates 'Short': self.size() is 10.",
            "codes 'toolong' of Shop 'corner' violates 'Short': self.size() is 7."),
        messages(result, "Code::"));
    assertEquals(
        List.of(4L, 4L),
        result.checks().stream()
            .filter(check -> check.constraint().qualifiedName().startsWith("Code::"))
            .map(OclResult.Check::evaluations)
            .toList());
  }

  @Test
  void enumerationIsAContextOfDefinitionsAndInvariants() {
    EEnum color = EcoreFactory.eINSTANCE.createEEnum();
    color.setName("Color");
    for (String name : List.of("red", "green")) {
      EEnumLiteral literal = EcoreFactory.eINSTANCE.createEEnumLiteral();
      literal.setName(name);
      literal.setValue(color.getELiterals().size());
      color.getELiterals().add(literal);
    }
    metamodel.getEClassifiers().add(color);
    EAttribute paint = EcoreFactory.eINSTANCE.createEAttribute();
    paint.setName("paint");
    paint.setEType(color);
    type("Shop").getEStructuralFeatures().add(paint);
    EObject shop = models.load("model.xmi");
    shop.eSet(paint, color.getEEnumLiteral("green").getInstance());
    OclRules rules =
        rules(
            """
            context Color
              def: isWarm() : Boolean = self = Color::red
              inv Warm: self.isWarm()
            context Shop inv WarmShop: paint.isWarm()
            """);
    assertEquals(List.of(), errors(rules));
    assertEquals(
        List.of("paint green of Shop 'corner' violates 'Warm': self.isWarm() is false."),
        messages(OclValidator.validate(rules, List.of(shop), element -> PLACE), "Color::"));
    assertEquals(
        1, messages(OclValidator.validate(rules, List.of(shop), e -> PLACE), "Shop::Warm").size());
  }

  private static List<String> messages(OclResult result, String rule) {
    return result.diagnostics().stream()
        .filter(each -> each.rule().startsWith(rule))
        .map(Diagnostic::message)
        .sorted()
        .toList();
  }

  @Test
  void bodyWithAnErrorIsTheReasonWhereItIsUsed() {
    EOperation total = type("Item").getEOperations().get(0);
    annotate(total, "body", "price.nothing");
    EObject shop = models.load("model.xmi");
    ExpressionLanguage language = ExpressionLanguage.of(List.of(metamodel));
    Evaluation run = Evaluations.over(List.of(shop));
    run.bind("self", shop.eContents().get(0));
    Invalid invalid =
        (Invalid)
            language
                .parse(
                    SourceText.of("t.mtl", "self.total() + 1").whole(),
                    language.root().with("self", type("Item")),
                    new ArrayList<>())
                .orElseThrow()
                .evaluate(run);
    assertEquals(
        "the expression of 'total' has an error: Real has no feature 'nothing'", invalid.reason());
  }

  @Test
  void conditionsInAnnotationsAreCountedAndOtherKeysAreNotIgnored() {
    EOperation total = type("Item").getEOperations().get(0);
    annotate(total, "pre_open", "true");
    annotate(total, "post", "result > 0.0");
    annotate(total, "bdoy", "1.0");
    annotate(type("Item").getEStructuralFeature("doubled"), "initial", "1.0");
    List<Diagnostic> said = rules().diagnostics();
    assertEquals(
        List.of("3 conditions of operations and initial values not checked: no program runs here."),
        said.stream()
            .filter(each -> each.id().equals("ocl.condition.unchecked"))
            .map(Diagnostic::message)
            .toList());
    assertEquals(
        List.of("The annotation 'bdoy' of total is not understood and is ignored."),
        said.stream()
            .filter(each -> each.id().equals("ocl.unsupported"))
            .map(Diagnostic::message)
            .toList());
  }

  @Test
  void staticDefinitionsBelongToTheirClass() {
    OclRules rules =
        rules(
            """
            context Item
              static def: limit : Real = 4.0
              static def: least(a : Real, b : Real) : Real = if a < b then a else b endif
              inv Limited: price <= Item::limit and Item::least(price, 9.0) = price
            """);
    assertEquals(List.of(), errors(rules));
    assertEquals(
        List.of("Item::Limited"),
        found(rules, "model.xmi").stream()
            .filter(each -> each.contains("Limited"))
            .map(each -> each.substring(0, each.indexOf(": ")))
            .distinct()
            .toList());
    assertEquals(
        1, errors(rules("context Item def: half : Real = 2.0 inv A: Item::half > 1.0")).size());
    assertEquals(
        1, errors(rules("context Item static def: half : Real = price inv A: true")).size());
  }

  @Test
  void sameInvariantInADocumentCountsOnce() {
    OclRules rules = rules("context Item inv PositivePrice: price > 0.0");
    assertEquals(5, rules.constraints().size());
  }

  @Test
  void messageInParenthesesIsEvaluated() {
    OclRules rules =
        rules("context Item inv Wanted('No ' + (if name = null then '?' else name endif)): false");
    assertEquals(
        List.of("Item::Wanted: No ?", "Item::Wanted: No car"),
        found(rules, "model.xmi").stream()
            .filter(each -> each.contains("Wanted"))
            .sorted()
            .limit(2)
            .toList());
  }

  @Test
  void failingDerivationIsUndefinedAndNoDefect() {
    EStructuralFeature doubled = type("Item").getEStructuralFeature("doubled");
    annotate(doubled, "derivation", "Sequence{1.0}->at(2)");
    EObject shop = models.load("model.xmi");
    List<Diagnostic> found =
        OclValidator.validate(rules(), List.of(shop), element -> SourceLocation.of("model.xmi"))
            .diagnostics();
    assertEquals(4, found.stream().filter(each -> each.id().equals("ocl.undefined")).count());
  }
}
