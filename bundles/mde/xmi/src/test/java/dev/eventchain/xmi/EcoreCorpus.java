package dev.eventchain.xmi;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.eclipse.emf.common.util.Enumerator;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EGenericType;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.ETypeParameter;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.InternalEObject;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.emf.ecore.util.ExtendedMetaData;
import org.eclipse.emf.ecore.util.FeatureMapUtil;
import org.eclipse.emf.ecore.xml.type.XMLTypePackage;

/** Generates metamodels with every construct of Ecore, and models of them, from a seed. */
final class EcoreCorpus {

  private static final EcoreFactory ECORE = EcoreFactory.eINSTANCE;
  private static final List<EDataType> TYPES =
      List.of(
          EcorePackage.Literals.ESTRING,
          EcorePackage.Literals.EINT,
          EcorePackage.Literals.EINTEGER_OBJECT,
          EcorePackage.Literals.ELONG,
          EcorePackage.Literals.ESHORT,
          EcorePackage.Literals.EBYTE,
          EcorePackage.Literals.EBOOLEAN,
          EcorePackage.Literals.EBOOLEAN_OBJECT,
          EcorePackage.Literals.EDOUBLE,
          EcorePackage.Literals.EFLOAT_OBJECT,
          EcorePackage.Literals.EBIG_DECIMAL,
          EcorePackage.Literals.EBIG_INTEGER,
          EcorePackage.Literals.ECHAR,
          XMLTypePackage.Literals.TOKEN,
          XMLTypePackage.Literals.INT);

  private final Random random;
  private final EPackage top = ECORE.createEPackage();
  private final List<EClass> classes = new ArrayList<>();
  private final List<EDataType> types = new ArrayList<>(TYPES);

  EcoreCorpus(long seed) {
    random = new Random(seed);
    name(top, "corpus", "http://example.org/corpus");
    EPackage inner = ECORE.createEPackage();
    name(inner, "inner", "http://example.org/corpus/inner");
    top.getESubpackages().add(inner);
    addTypes();
    EClass base = addClass(top, "Base");
    base.setAbstract(true);
    add(base, ECORE.createEAttribute(), "id", EcorePackage.Literals.ESTRING, 0, 1);
    ((EAttribute) base.getEStructuralFeature("id")).setID(true);
    for (int i = 0; i < 3; i++) {
      EClass above = classes.get(random.nextInt(classes.size()));
      addClass(i == 0 ? top : inner, "C" + i).getESuperTypes().add(above);
    }
    addGenerics(base);
    List.copyOf(classes.subList(1, classes.size())).forEach(this::addFeatures);
    addFeatureMap(classes.get(1));
    addMap(classes.get(1));
  }

  EPackage metamodel() {
    return top;
  }

  private static void name(EPackage ePackage, String name, String uri) {
    ePackage.setName(name);
    ePackage.setNsPrefix(name);
    ePackage.setNsURI(uri);
  }

  private void addTypes() {
    EEnum colour = ECORE.createEEnum();
    colour.setName("Colour");
    for (String literal : List.of("red", "green")) {
      EEnumLiteral made = ECORE.createEEnumLiteral();
      made.setName(literal);
      made.setValue(colour.getELiterals().size() * 3);
      colour.getELiterals().add(made);
    }
    top.getEClassifiers().add(colour);
    types.add(colour);
    EDataType small = ECORE.createEDataType();
    small.setName("Small");
    small.setInstanceClassName("int");
    EcoreUtil.setAnnotation(small, ExtendedMetaData.ANNOTATION_URI, "maxInclusive", "5");
    EDataType foreign = ECORE.createEDataType();
    foreign.setName("Foreign");
    foreign.setInstanceClassName("org.example.Foreign");
    for (EDataType type : List.of(small, foreign)) {
      top.getEClassifiers().add(type);
      types.add(type);
    }
  }

  private EClass addClass(EPackage home, String name) {
    EClass made = ECORE.createEClass();
    made.setName(name);
    home.getEClassifiers().add(made);
    classes.add(made);
    return made;
  }

  private void addGenerics(EClass base) {
    EClass generic = ECORE.createEClass();
    generic.setName("Holder");
    ETypeParameter parameter = ECORE.createETypeParameter();
    parameter.setName("T");
    EGenericType bound = ECORE.createEGenericType();
    bound.setEClassifier(base);
    parameter.getEBounds().add(bound);
    generic.getETypeParameters().add(parameter);
    EReference held = ECORE.createEReference();
    held.setName("held");
    EGenericType type = ECORE.createEGenericType();
    type.setETypeParameter(parameter);
    held.setEGenericType(type);
    generic.getEStructuralFeatures().add(held);
    generic.setAbstract(true);
    top.getEClassifiers().add(generic);
    EGenericType filled = ECORE.createEGenericType();
    filled.setEClassifier(generic);
    EGenericType argument = ECORE.createEGenericType();
    argument.setEClassifier(base);
    filled.getETypeArguments().add(argument);
    classes.get(1).getEGenericSuperTypes().add(filled);
  }

  private <F extends EStructuralFeature> F add(
      EClass owner, F feature, String name, EClassifier type, int lower, int upper) {
    feature.setName(name);
    feature.setEType(type);
    feature.setLowerBound(lower);
    feature.setUpperBound(upper);
    owner.getEStructuralFeatures().add(feature);
    return feature;
  }

  private int upper() {
    return List.of(1, 1, 2, -1).get(random.nextInt(4));
  }

  private void addFeatures(EClass owner) {
    String prefix = owner.getName().toLowerCase(java.util.Locale.ROOT);
    for (int i = 0; i < 6; i++) {
      EDataType type = types.get(random.nextInt(types.size()));
      EAttribute made =
          add(owner, ECORE.createEAttribute(), prefix + "A" + i, type, random.nextInt(2), upper());
      made.setUnique(random.nextBoolean());
      made.setUnsettable(random.nextInt(4) == 0);
      made.setOrdered(random.nextBoolean());
    }
    EClass parts = classes.get(1 + random.nextInt(classes.size() - 1));
    EReference part = add(owner, ECORE.createEReference(), prefix + "Parts", parts, 0, -1);
    part.setContainment(true);
    EReference plain = add(owner, ECORE.createEReference(), prefix + "R", owner, 0, upper());
    plain.setResolveProxies(random.nextBoolean());
    EReference one = add(owner, ECORE.createEReference(), prefix + "One", parts, 0, upper());
    EReference back = add(parts, ECORE.createEReference(), prefix + "Back", owner, 0, upper());
    one.setEOpposite(back);
    back.setEOpposite(one);
  }

  private void addFeatureMap(EClass owner) {
    EAttribute map =
        add(
            owner,
            ECORE.createEAttribute(),
            "group",
            EcorePackage.Literals.EFEATURE_MAP_ENTRY,
            0,
            -1);
    ExtendedMetaData.INSTANCE.setFeatureKind(map, ExtendedMetaData.GROUP_FEATURE);
    ExtendedMetaData.INSTANCE.setName(map, "group:0");
    for (String name : List.of("text", "member")) {
      boolean isText = name.equals("text");
      EStructuralFeature made =
          isText
              ? add(owner, ECORE.createEAttribute(), name, EcorePackage.Literals.ESTRING, 0, -1)
              : add(owner, ECORE.createEReference(), name, classes.get(2), 0, -1);
      made.setVolatile(true);
      made.setTransient(true);
      made.setDerived(true);
      ExtendedMetaData.INSTANCE.setFeatureKind(made, ExtendedMetaData.ELEMENT_FEATURE);
      ExtendedMetaData.INSTANCE.setName(made, name);
      ExtendedMetaData.INSTANCE.setGroup(made, map);
      if (made instanceof EReference reference) {
        reference.setContainment(true);
      }
    }
  }

  private void addMap(EClass owner) {
    EClass entry = ECORE.createEClass();
    entry.setName("Entry");
    entry.setInstanceClassName("java.util.Map$Entry");
    top.getEClassifiers().add(entry);
    add(entry, ECORE.createEAttribute(), "key", EcorePackage.Literals.ESTRING, 1, 1);
    add(entry, ECORE.createEReference(), "value", owner, 0, 1);
    add(owner, ECORE.createEReference(), "entries", entry, 0, -1).setContainment(true);
  }

  /** Returns a model of a generated metamodel that was written and read again. */
  EObject model(EPackage read) {
    EClass type = (EClass) read.getEClassifier("C0");
    List<EObject> made = new ArrayList<>();
    EObject root = make(type, made, 0);
    for (EObject element : made) {
      for (EReference reference : element.eClass().getEAllReferences()) {
        if (!reference.isContainment() && !reference.isContainer() && !reference.isDerived()) {
          refer(element, reference, made);
        }
      }
    }
    return root;
  }

  private EObject make(EClass type, List<EObject> made, int depth) {
    EObject element = EcoreUtil.create(type);
    made.add(element);
    for (EStructuralFeature feature : type.getEAllStructuralFeatures()) {
      boolean skipped = FeatureMapUtil.isFeatureMap(feature) || random.nextInt(4) == 0;
      if (feature.getName().equals("id")) {
        element.eSet(feature, "e" + made.size());
      } else if (feature instanceof EAttribute attribute && !skipped) {
        fill(element, attribute);
      } else if (feature instanceof EReference r && r.isContainment() && depth < 3 && !skipped) {
        for (int i = random.nextInt(3); i > 0; i--) {
          list(element, r).add(make(r.getEReferenceType(), made, depth + 1));
        }
      }
    }
    return element;
  }

  @SuppressWarnings("unchecked")
  private static List<Object> list(EObject element, EStructuralFeature feature) {
    return (List<Object>) element.eGet(feature);
  }

  private void fill(EObject element, EAttribute attribute) {
    EDataType type = attribute.getEAttributeType();
    if (!attribute.isMany()) {
      element.eSet(attribute, value(type));
      return;
    }
    for (int i = random.nextInt(4); i > 0; i--) {
      list(element, attribute).add(value(type));
    }
  }

  private Object value(EDataType type) {
    if (type instanceof EEnum eEnum) {
      Enumerator literal = eEnum.getELiterals().get(random.nextInt(2)).getInstance();
      return literal;
    }
    String name = String.valueOf(type.getInstanceClassName());
    String number = String.valueOf(random.nextInt(8));
    String text = name.toLowerCase(java.util.Locale.ROOT).endsWith("boolean") ? "true" : number;
    return EcoreUtil.createFromString(type, text);
  }

  /** Sets a reference; never to an own opposite, which EMF's reader moves to the front. */
  private void refer(EObject element, EReference reference, List<EObject> made) {
    List<EObject> targets =
        made.stream()
            .filter(reference.getEReferenceType()::isInstance)
            .filter(target -> target != element || reference.getEOpposite() == null)
            .toList();
    if (targets.isEmpty() || random.nextBoolean()) {
      return;
    }
    EObject target = targets.get(random.nextInt(targets.size()));
    if (!reference.isMany()) {
      ((InternalEObject) element).eSet(reference, target);
    } else if (!list(element, reference).contains(target)) {
      list(element, reference).add(target);
    }
  }
}
