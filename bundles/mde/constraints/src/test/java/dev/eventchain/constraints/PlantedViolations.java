package dev.eventchain.constraints;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import org.eclipse.emf.common.util.EList;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.resource.impl.ResourceImpl;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * A metamodel, constraints on it and a model, made together at random: each constraint has a
 * feature of its own, and its satisfying and violating values are known without an evaluation.
 */
final class PlantedViolations {

  /** The integer types of Ecore, each with a conversion from long. */
  private record Whole(EDataType type, Function<Long, Object> of, long most) {}

  private static final List<Whole> WHOLES =
      List.of(
          new Whole(EcorePackage.Literals.EBYTE, Long::byteValue, Byte.MAX_VALUE),
          new Whole(EcorePackage.Literals.EBYTE_OBJECT, Long::byteValue, Byte.MAX_VALUE),
          new Whole(EcorePackage.Literals.ESHORT, Long::shortValue, Short.MAX_VALUE),
          new Whole(EcorePackage.Literals.ESHORT_OBJECT, Long::shortValue, Short.MAX_VALUE),
          new Whole(EcorePackage.Literals.EINT, Long::intValue, Integer.MAX_VALUE),
          new Whole(EcorePackage.Literals.EINTEGER_OBJECT, Long::intValue, Integer.MAX_VALUE),
          new Whole(EcorePackage.Literals.ELONG, each -> each, 1L << 60),
          new Whole(EcorePackage.Literals.ELONG_OBJECT, each -> each, 1L << 60),
          new Whole(EcorePackage.Literals.EBIG_INTEGER, BigInteger::valueOf, 1L << 60));

  /** The real types of Ecore, each with a conversion from doubles that all of them can hold. */
  private record Real(EDataType type, Function<Double, Object> of) {}

  private static final List<Real> REALS =
      List.of(
          new Real(EcorePackage.Literals.EFLOAT, Double::floatValue),
          new Real(EcorePackage.Literals.EFLOAT_OBJECT, Double::floatValue),
          new Real(EcorePackage.Literals.EDOUBLE, each -> each),
          new Real(EcorePackage.Literals.EDOUBLE_OBJECT, each -> each),
          new Real(EcorePackage.Literals.EBIG_DECIMAL, BigDecimal::valueOf));

  /** A constraint and values of its feature. */
  private record Planted(
      EStructuralFeature feature, String text, List<?> satisfying, List<?> violating) {}

  private final Random random;
  private final EPackage metamodel = EcoreFactory.eINSTANCE.createEPackage();
  private final EClass type = EcoreFactory.eINSTANCE.createEClass();
  private final EEnum colour = EcoreFactory.eINSTANCE.createEEnum();
  private final List<Planted> planted = new ArrayList<>();
  private final Set<String> expected = new TreeSet<>();
  private EObject root;

  private PlantedViolations(long seed) {
    this.random = new Random(seed);
  }

  static PlantedViolations of(long seed) {
    PlantedViolations made = new PlantedViolations(seed);
    made.makeMetamodel();
    made.makeModel();
    return made;
  }

  EPackage metamodel() {
    return metamodel;
  }

  EObject root() {
    return root;
  }

  /** Returns the document with the constraints; {@code Pn} is about the feature {@code fn}. */
  String document() {
    StringBuilder text = new StringBuilder("context Element\n");
    for (int i = 0; i < planted.size(); i++) {
      text.append("inv P").append(i).append(": ").append(planted.get(i).text()).append('\n');
    }
    return text.toString();
  }

  /** Returns the expected violations: {@code Element::P3 7} for the seventh element. */
  Set<String> expected() {
    return expected;
  }

  private void makeMetamodel() {
    metamodel.setName("planted");
    metamodel.setNsPrefix("planted");
    metamodel.setNsURI("http://example.org/planted");
    type.setName("Element");
    colour.setName("Colour");
    for (String name : List.of("RED", "GREEN", "BLUE")) {
      EEnumLiteral literal = EcoreFactory.eINSTANCE.createEEnumLiteral();
      literal.setName(name);
      literal.setValue(colour.getELiterals().size());
      literal.setInstance(literal);
      colour.getELiterals().add(literal);
    }
    metamodel.getEClassifiers().add(type);
    metamodel.getEClassifiers().add(colour);
    EReference children = EcoreFactory.eINSTANCE.createEReference();
    children.setName("children");
    children.setEType(type);
    children.setContainment(true);
    children.setUpperBound(-1);
    type.getEStructuralFeatures().add(children);
    EAttribute number = EcoreFactory.eINSTANCE.createEAttribute();
    number.setName("number");
    number.setEType(EcorePackage.Literals.EINT);
    type.getEStructuralFeatures().add(number);
    int constraints = 1 + random.nextInt(8);
    for (int i = 0; i < constraints; i++) {
      plant();
    }
  }

  private void plant() {
    switch (random.nextInt(6)) {
      case 0 -> whole(one(WHOLES));
      case 1 -> wholes(one(WHOLES));
      case 2 -> real(one(REALS));
      case 3 -> text();
      case 4 -> literal();
      default -> flag();
    }
  }

  private void whole(Whole of) {
    EAttribute feature = attribute(of.type(), false);
    int small = 1 + random.nextInt(100);
    long limit = random.nextBoolean() ? small : of.most() - small % 3 - 2;
    String self = one(List.of("", "self.")) + feature.getName();
    List<Object> below = values(of, limit - 1, limit - 2, -limit);
    List<Object> equal = values(of, limit);
    List<Object> above = values(of, limit + 1, limit + 2);
    switch (random.nextInt(7)) {
      case 0 -> add(feature, self + " < " + limit, below, join(equal, above));
      case 1 -> add(feature, self + " >= " + limit, join(equal, above), below);
      case 2 -> add(feature, self + " = " + limit, equal, join(below, above));
      case 3 -> add(feature, limit + " <> " + self, join(below, above), equal);
      case 4 -> add(feature, "Set{" + limit + "}->includes(" + self + ")", equal, below);
      case 5 -> add(feature, "Sequence{0, " + limit + "}->excludes(" + self + ")", above, equal);
      default -> add(feature, self + " - " + limit + " > 0", above, join(equal, below));
    }
  }

  private void wholes(Whole of) {
    EAttribute feature = attribute(of.type(), true);
    feature.setUnique(random.nextBoolean());
    feature.setOrdered(random.nextBoolean());
    String self = feature.getName();
    List<Object> small = List.of(values(of), values(of, 1), values(of, 2, 1));
    List<Object> large = List.of(values(of, 99), values(of, 3, 99), values(of, 98, 1, 2));
    List<Object> withTwo = List.of(values(of, 2), values(of, 1, 2), values(of, 5, 2, 7));
    List<Object> withoutTwo = List.of(values(of), values(of, 1), values(of, 4, 5));
    List<Object> three = List.of(values(of, 1, 2, 3), values(of, 7, 5, 6));
    switch (random.nextInt(7)) {
      case 0 -> add(feature, self + "->forAll(x | x < 50)", small, large);
      case 1 -> add(feature, self + "->exists(x | x > 50)", large, small);
      case 2 -> add(feature, self + "->includes(2)", withTwo, withoutTwo);
      case 3 -> add(feature, self + "->count(2) = 1", withTwo, withoutTwo);
      case 4 -> add(feature, self + "->size() = 3", three, join(small, List.of()));
      case 5 -> add(feature, self + "->sum() > 50", large, small);
      default ->
          add(feature, self + "->asSet() = Set{2}", List.of(values(of, 2)), join(three, large));
    }
  }

  private void real(Real of) {
    EAttribute feature = attribute(of.type(), false);
    String self = feature.getName();
    List<Object> half = List.of(of.of().apply(0.5), of.of().apply(-7.25));
    List<Object> four = List.of(of.of().apply(4.0));
    List<Object> more = List.of(of.of().apply(4.5), of.of().apply(1024.0));
    switch (random.nextInt(5)) {
      case 0 -> add(feature, self + " = 4", four, join(half, more));
      case 1 -> add(feature, self + " < 4.0", half, join(four, more));
      case 2 -> add(feature, "Set{4, 5}->includes(" + self + ")", four, join(half, more));
      case 3 -> add(feature, self + ".floor() = 4", join(four, more.subList(0, 1)), half);
      default -> add(feature, self + " * 2 > 8", more, join(four, half));
    }
  }

  private void text() {
    EAttribute feature = attribute(EcorePackage.Literals.ESTRING, false);
    String self = feature.getName();
    switch (random.nextInt(4)) {
      case 0 -> add(feature, self + " <> 'it\\'s'", List.of("its", ""), List.of("it's"));
      case 1 -> add(feature, self + ".size() > 2", List.of("abc", "größe"), List.of("", "ab"));
      case 2 -> add(feature, self + ".toUpper() = 'AB'", List.of("ab", "aB"), List.of("b", ""));
      default -> add(feature, "Set{'x', 'y'}->includes(" + self + ")", List.of("x"), List.of("X"));
    }
  }

  private void literal() {
    EAttribute feature = attribute(colour, false);
    Object red = colour.getELiterals().get(0);
    Object green = colour.getELiterals().get(1);
    String self = feature.getName();
    if (random.nextBoolean()) {
      add(feature, self + " = Colour::GREEN", List.of(green), List.of(red));
    } else {
      String text = "Set{Colour::RED, Colour::BLUE}->includes(" + self + ")";
      add(feature, text, List.of(red), List.of(green));
    }
  }

  private void flag() {
    EAttribute feature = attribute(EcorePackage.Literals.EBOOLEAN, false);
    boolean wanted = random.nextBoolean();
    add(
        feature,
        wanted ? feature.getName() : "not " + feature.getName(),
        List.of(wanted),
        List.of(!wanted));
  }

  private EAttribute attribute(EDataType dataType, boolean many) {
    EAttribute attribute = EcoreFactory.eINSTANCE.createEAttribute();
    attribute.setName("f" + planted.size());
    attribute.setEType(dataType);
    attribute.setUpperBound(many ? -1 : 1);
    type.getEStructuralFeatures().add(attribute);
    return attribute;
  }

  private void add(EStructuralFeature feature, String text, List<?> satisfying, List<?> violating) {
    planted.add(new Planted(feature, text, satisfying, violating));
  }

  private static List<Object> values(Whole of, long... numbers) {
    List<Object> values = new ArrayList<>();
    for (long number : numbers) {
      values.add(of.of().apply(number));
    }
    return values;
  }

  private static List<Object> join(List<?> first, List<?> second) {
    List<Object> all = new ArrayList<>(first);
    all.addAll(second);
    return all;
  }

  private <T> T one(List<? extends T> of) {
    return of.get(random.nextInt(of.size()));
  }

  private void makeModel() {
    int size = 1 + random.nextInt(5);
    for (int i = 0; i < size; i++) {
      EObject element = EcoreUtil.create(type);
      element.eSet(type.getEStructuralFeature("number"), i);
      for (int each = 0; each < planted.size(); each++) {
        Planted rule = planted.get(each);
        boolean violates = random.nextInt(4) == 0;
        Object value = one(violates ? rule.violating() : rule.satisfying());
        set(element, rule.feature(), value);
        if (violates) {
          expected.add("Element::P" + each + " " + i);
        }
      }
      if (root == null) {
        root = element;
        new ResourceImpl().getContents().add(root);
      } else {
        list(root, type.getEStructuralFeature("children")).add(element);
      }
    }
  }

  private static void set(EObject element, EStructuralFeature feature, Object value) {
    if (feature.isMany()) {
      list(element, feature).addAll((List<?>) value);
    } else {
      element.eSet(feature, value);
    }
  }

  @SuppressWarnings("unchecked")
  private static EList<Object> list(EObject element, EStructuralFeature feature) {
    return (EList<Object>) element.eGet(feature);
  }
}
