package dev.eventchain.pipeline;

import static dev.eventchain.pipeline.PlantedMetamodel.BASE;
import static dev.eventchain.pipeline.PlantedMetamodel.TARGET;

import java.util.List;
import java.util.Locale;
import java.util.Random;

/** Models that violate their metamodel, whatever the constraints. */
final class PlantedFaults {

  private final Plants plants;
  private final PlantedMetamodel metamodel;
  private final Random random;

  PlantedFaults(Plants plants, PlantedMetamodel metamodel, Random random) {
    this.plants = plants;
    this.metamodel = metamodel;
    this.random = random;
  }

  /** Plants missing required values. */
  void required() {
    PlantedMetamodel.Type above = metamodel.type(BASE, random.nextBoolean());
    PlantedMetamodel.Type type = metamodel.type(above, false);
    switch (random.nextInt(3)) {
      case 0 -> {
        metamodel.attribute(above, "word", "EString", "lowerBound=\"1\"");
        plants.element(type).with("word", "");
        plants.element(type).expect("ecore.required");
      }
      case 1 -> {
        metamodel.reference(above, "held", TARGET, "lowerBound=\"1\" ");
        plants.refer("held", plants.element(type), List.of(Plants.target(1)));
        plants.element(type).expect("ecore.required");
      }
      default -> {
        metamodel.reference(above, "held", TARGET, Plants.CONTAINED + "lowerBound=\"1\" ");
        Plants.contain("held", plants.element(type), List.of(Plants.target(1)));
        plants.element(type).expect("ecore.required");
      }
    }
  }

  /** Plants too few and too many values, of attributes and of both kinds of references. */
  void bounds() {
    PlantedMetamodel.Type type = metamodel.type(metamodel.type(BASE, true), false);
    int lower = random.nextInt(3);
    int upper = Math.max(2, lower) + random.nextInt(2);
    String bounds =
        String.format(Locale.ROOT, "lowerBound=\"%d\" upperBound=\"%d\" ", lower, upper);
    int kind = random.nextInt(4);
    if (kind == 0) {
      metamodel.attribute(type, "held", "EInt", bounds + "unique=\"false\"");
    } else if (kind == 1) {
      metamodel.featureMap(type, "map");
      metamodel.memberOfMap(type, "map", "held", null, bounds);
    } else {
      metamodel.reference(type, "held", TARGET, bounds + (kind == 2 ? Plants.CONTAINED : ""));
    }
    for (int size = 0; size <= upper + 1; size++) {
      PlantedElement element = plants.element(type);
      element.expect(size < lower ? "ecore.required" : size > upper ? "ecore.bound" : "");
      for (int i = 0; i < size; i++) {
        switch (kind) {
          case 0, 1 -> element.value("held", String.valueOf(i));
          case 2 -> element.part("held", Plants.target(i));
          default -> plants.refer("held", element, List.of(Plants.target(i)));
        }
      }
    }
  }

  /** Plants duplicate values in lists that are unique or not. */
  void twice() {
    PlantedMetamodel.Type type = metamodel.type(BASE, false);
    boolean inMap = random.nextBoolean();
    boolean isUnique = random.nextBoolean();
    String more = Plants.MANY + "unique=\"" + isUnique + "\" ";
    if (inMap) {
      metamodel.featureMap(type, "map");
      metamodel.memberOfMap(type, "map", "word", null, more);
      metamodel.memberOfMap(type, "map", "held", TARGET, Plants.MANY);
    } else {
      metamodel.attribute(type, "word", "EString", more);
      metamodel.reference(type, "held", TARGET, Plants.MANY);
    }
    PlantedElement target = Plants.target(1);
    PlantedElement other = Plants.target(2);
    plants.refer(
        "held", plants.element(type).value("word", "a").value("word", "b"), List.of(target, other));
    plants.element(type).to("held", List.of(target, other, target)).expect("ecore.unique");
    String expected = isUnique ? "ecore.unique" : "";
    plants.element(type).value("word", "a").value("word", "b").value("word", "a").expect(expected);
  }

  /** Plants bidirectional references, some of them set at one end only. */
  void singleEnds() {
    PlantedMetamodel.Type left = metamodel.type(BASE, false);
    PlantedMetamodel.Type right = random.nextBoolean() ? left : metamodel.type(BASE, false);
    boolean many = random.nextBoolean();
    String bounds = many ? Plants.MANY : "";
    metamodel.reference(left, "to", right, bounds + PlantedMetamodel.opposite(left, right, "from"));
    metamodel.reference(right, "from", left, bounds + PlantedMetamodel.opposite(right, left, "to"));
    for (int i = 1 + random.nextInt(3); i > 0; i--) {
      PlantedElement first = plants.element(left);
      PlantedElement second = plants.element(right);
      int ends = random.nextInt(4);
      if (ends != 1) {
        first.to("to", second).expect(ends == 0 ? "ecore.opposite" : "");
      }
      if (ends != 0) {
        second.to("from", first).expect(ends == 1 ? "ecore.opposite" : "");
      }
    }
  }
}
