package dev.eventchain.ocl;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.impl.ResourceImpl;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** Models of the metamodel {@code everything}, with values that are edge cases. */
final class GeneratedModels {

  private static final List<Object> WHOLES = List.of(0, 1, 2, -1, 7, 2147483647, -2147483648);
  private static final List<Object> REALS =
      List.of(0.0, 0.5, -0.0, 1.0, 2.0, Double.NaN, Double.POSITIVE_INFINITY, -1.0e300);
  private static final List<Object> TEXTS = Arrays.asList("", "a", "b", "12", "x,y z", "Ab", null);

  private final EPackage metamodel;
  private final Random random;

  private GeneratedModels(EPackage metamodel, long seed) {
    this.metamodel = metamodel;
    this.random = new Random(seed);
  }

  /** Returns the things of a model, the root first; the same for the same seed. */
  static List<EObject> things(EPackage metamodel, long seed) {
    return new GeneratedModels(metamodel, seed).make();
  }

  private List<EObject> make() {
    List<EObject> things = new ArrayList<>();
    int size = 1 + random.nextInt(6);
    for (int i = 0; i < size; i++) {
      String type = List.of("Thing", "Special", "Rare").get(random.nextInt(3));
      things.add(EcoreUtil.create((EClass) metamodel.getEClassifier(type)));
    }
    new ResourceImpl().getContents().add(things.get(0));
    for (int i = 1; i < size; i++) {
      many(things.get(random.nextInt(i)), "parts").add(things.get(i));
    }
    for (EObject thing : things) {
      fill(thing);
      connect(thing, things);
    }
    return things;
  }

  private void fill(EObject thing) {
    set(thing, "name", of(TEXTS));
    set(thing, "flag", random.nextBoolean());
    set(thing, "maybe", of(Arrays.asList(true, false, null)));
    set(thing, "whole", of(WHOLES));
    set(thing, "long", of(List.of(0L, 1L, 4294967296L, 2147483648L, Long.MAX_VALUE)));
    set(thing, "short", of(List.of((short) 0, (short) 3)));
    set(thing, "perhaps", of(Arrays.asList(1, 5, null)));
    set(thing, "big", of(Arrays.asList(BigInteger.TWO, BigInteger.TEN.pow(30), null)));
    set(thing, "real", of(REALS));
    set(thing, "float", of(List.of(0f, 1.5f, Float.NaN)));
    set(thing, "partial", of(Arrays.asList(1.0, 2.5, null)));
    set(thing, "exact", of(Arrays.asList(new BigDecimal("1.10"), null)));
    set(thing, "colour", colour().getELiterals().get(random.nextInt(2)).getInstance());
    add(thing, "numbers", WHOLES);
    add(thing, "words", TEXTS);
    add(thing, "marks", REALS);
    add(thing, "titles", TEXTS);
  }

  private EEnum colour() {
    return (EEnum) metamodel.getEClassifier("Colour");
  }

  private void connect(EObject thing, List<EObject> things) {
    if (random.nextInt(3) > 0) {
      set(thing, "next", of(things));
    }
    List<EObject> others = new ArrayList<>(things);
    Collections.shuffle(others, random);
    many(thing, "friends").addAll(others.subList(0, random.nextInt(others.size() + 1)));
  }

  private void add(EObject thing, String feature, List<Object> values) {
    for (int i = random.nextInt(4); i > 0; i--) {
      many(thing, feature).add(of(values));
    }
  }

  private <T> T of(List<T> values) {
    return values.get(random.nextInt(values.size()));
  }

  private static void set(EObject thing, String feature, Object value) {
    thing.eSet(thing.eClass().getEStructuralFeature(feature), value);
  }

  @SuppressWarnings("unchecked") // EMF's lists know their element type at run time only
  private static List<Object> many(EObject thing, String feature) {
    return (List<Object>) thing.eGet(thing.eClass().getEStructuralFeature(feature));
  }
}
