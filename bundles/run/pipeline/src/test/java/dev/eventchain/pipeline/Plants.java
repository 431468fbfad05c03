package dev.eventchain.pipeline;

import static dev.eventchain.pipeline.PlantedMetamodel.BASE;
import static dev.eventchain.pipeline.PlantedMetamodel.COLOUR;
import static dev.eventchain.pipeline.PlantedMetamodel.COLOURS;
import static dev.eventchain.pipeline.PlantedMetamodel.SPECIAL;
import static dev.eventchain.pipeline.PlantedMetamodel.TARGET;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

/**
 * The faults that can be planted: each has its own classes with a few elements, and the expected
 * findings.
 */
final class Plants {

  static final String MANY = "upperBound=\"-1\" ";
  static final String CONTAINED = "containment=\"true\" ";

  /** Adds Targets to an element, in the feature of a rule. */
  private interface Holder {
    void hold(PlantedElement owner, List<PlantedElement> targets);
  }

  private final PlantedMetamodel metamodel;
  private final Random random;
  private final List<PlantedElement> elements = new ArrayList<>();
  private final PlantedFaults faults;

  Plants(PlantedMetamodel metamodel, Random random) {
    this.metamodel = metamodel;
    this.random = random;
    this.faults = new PlantedFaults(this, metamodel, random);
  }

  /** Returns the root elements; others are their parts. */
  List<PlantedElement> elements() {
    return elements;
  }

  void plant() {
    switch (random.nextInt(15)) {
      case 0, 1 -> one();
      case 2, 3 -> many();
      case 4 -> inverse();
      case 5 -> derived();
      case 6 -> featureMap();
      case 7 -> faults.required();
      case 8 -> faults.bounds();
      case 9 -> faults.singleEnds();
      case 10 -> overriding();
      case 11 -> unique();
      case 12 -> parts();
      case 13 -> faults.twice();
      default -> literals();
    }
  }

  private <T> T any(List<T> values) {
    return values.get(random.nextInt(values.size()));
  }

  PlantedElement element(PlantedMetamodel.Type type) {
    PlantedElement element = new PlantedElement(type);
    elements.add(element);
    return element;
  }

  private PlantedMetamodel.Type type() {
    return metamodel.type(BASE, false);
  }

  /** Returns the class or a subclass in any package. */
  private PlantedMetamodel.Type below(PlantedMetamodel.Type type) {
    return random.nextBoolean() ? type : metamodel.type(type, false);
  }

  static PlantedElement target(int mark) {
    return new PlantedElement(mark < 10 ? TARGET : SPECIAL)
        .with("mark", mark)
        .with("colour", COLOURS.get(mark % 3));
  }

  /** Plants elements for a rule, some of which satisfy it, violate it, or give it no value. */
  private void cases(
      PlantedMetamodel.Type context,
      PlantedMetamodel.Type of,
      String feature,
      PlantedRule rule,
      Holder holder) {
    String name = metamodel.rule(context, rule.about(feature));
    for (int i = 1 + random.nextInt(3); i > 0; i--) {
      String expected = "";
      String cases = rule.satisfying();
      int kind = random.nextInt(6);
      if (kind < 2 && !rule.violating().isEmpty()) {
        expected = name;
        cases = rule.violating();
      } else if (kind == 2 && !rule.undefined().isEmpty()) {
        expected = "ocl.undefined";
        cases = rule.undefined();
      }
      List<PlantedElement> targets = new ArrayList<>();
      any(PlantedRule.cases(cases)).forEach(mark -> targets.add(target(mark)));
      PlantedElement owner = element(of).expect(expected);
      holder.hold(owner, targets);
    }
  }

  void refer(String feature, PlantedElement owner, List<PlantedElement> targets) {
    elements.addAll(targets);
    owner.to(feature, targets);
  }

  static void contain(String feature, PlantedElement owner, List<PlantedElement> parts) {
    parts.forEach(part -> owner.part(feature, part));
  }

  private void one() {
    PlantedMetamodel.Type context = metamodel.type(BASE, random.nextBoolean());
    PlantedMetamodel.Type of = metamodel.type(context, false);
    boolean contained = random.nextBoolean();
    metamodel.reference(context, "held", TARGET, contained ? CONTAINED : "");
    cases(
        context,
        of,
        "held",
        any(PlantedRule.OF_ONE),
        (owner, targets) -> {
          if (contained) {
            contain("held", owner, targets);
          } else {
            refer("held", owner, targets);
          }
        });
  }

  private void many() {
    PlantedMetamodel.Type declaring = metamodel.type(BASE, true);
    PlantedMetamodel.Type context = metamodel.type(declaring, false);
    boolean contained = random.nextBoolean();
    boolean ordered = random.nextBoolean();
    metamodel.reference(
        declaring,
        "held",
        TARGET,
        MANY + (contained ? CONTAINED : "") + (ordered ? "" : "ordered=\"false\" "));
    PlantedRule rule = any(ordered ? PlantedRule.OF_SEVERAL : PlantedRule.OF_MANY);
    cases(
        context,
        below(context),
        "held",
        rule,
        (owner, targets) -> {
          if (contained) {
            contain("held", owner, targets);
          } else {
            refer("held", owner, targets);
          }
        });
  }

  /** Plants Targets of a separate class with a reference back to their holder. */
  private void inverse() {
    PlantedMetamodel.Type context = type();
    PlantedMetamodel.Type held = metamodel.type(TARGET, false);
    metamodel.reference(
        context, "held", held, MANY + PlantedMetamodel.opposite(context, held, "by"));
    metamodel.reference(held, "by", context, PlantedMetamodel.opposite(held, context, "held"));
    String back = metamodel.rule(held, "by <> null and by.held->includes(self)");
    element(held).expect(back);
    for (int i = random.nextInt(3); i > 0; i--) {
      PlantedElement owner = element(context);
      for (int mark = 1; mark < random.nextInt(4); mark++) {
        PlantedElement target = element(held).with("mark", mark).to("by", owner);
        owner.to("held", target);
      }
    }
  }

  private void derived() {
    PlantedMetamodel.Type context = type();
    metamodel.reference(context, "all", TARGET, MANY);
    metamodel.derived(
        context, "held", TARGET, MANY + "ordered=\"false\" ", "all->select(mark > 0)->asSet()");
    metamodel.derived(context, "sum", null, "", "held.mark->sum()");
    PlantedRule ofSum = new PlantedRule("sum > 10", "5 6|11", "-|1 2", "");
    PlantedRule rule = random.nextBoolean() ? ofSum : any(PlantedRule.OF_MANY);
    cases(context, below(context), "held", rule, (owner, all) -> refer("all", owner, all));
  }

  private void featureMap() {
    PlantedMetamodel.Type context = type();
    boolean contained = random.nextBoolean();
    boolean bounded = random.nextBoolean();
    metamodel.featureMap(context, "map");
    metamodel.memberOfMap(context, "map", "word", null, MANY + "unique=\"false\" ");
    metamodel.memberOfMap(context, "map", "held", TARGET, MANY + (contained ? CONTAINED : ""));
    if (bounded) {
      String name = metamodel.rule(context, "word->size() < 3 and word->excludes('x')");
      for (List<String> words : List.of(List.<String>of(), List.of("a"), List.of("b", "b"))) {
        PlantedElement element = element(context);
        words.forEach(word -> element.value("word", word));
      }
      element(context).value("word", "a").value("word", "x").expect(name);
      element(context).value("word", "a").value("word", "b").value("word", "c").expect(name);
    }
    PlantedRule rule = any(random.nextBoolean() ? PlantedRule.OF_MANY : PlantedRule.OF_SEVERAL);
    if (bounded) {
      return;
    }
    cases(
        context,
        below(context),
        "held",
        rule,
        (owner, targets) -> {
          owner.value("word", "first");
          if (contained) {
            contain("held", owner, targets);
          } else {
            refer("held", owner, targets);
          }
          owner.value("word", "last");
        });
  }

  /** Plants an operation with several bodies: the nearest inherited one applies to an element. */
  private void overriding() {
    PlantedMetamodel.Type above = metamodel.type(BASE, random.nextBoolean());
    PlantedMetamodel.Type middle = metamodel.type(above, false);
    PlantedMetamodel.Type lowest = metamodel.type(middle, false);
    metamodel.attribute(above, "size", "EInt", "");
    metamodel.operation(above, "most", "5");
    metamodel.operation(middle, "most", "10");
    boolean both = random.nextBoolean();
    if (both) {
      metamodel.operation(lowest, "most", "self.size + 1");
    }
    String rule = metamodel.rule(above, "size <= most()");
    String narrower = metamodel.rule(lowest, "size > 2");
    for (int size : List.of(1, 7, 20)) {
      element(middle).with("size", size).expect(size > 10 ? rule : "");
      PlantedElement element = element(lowest).with("size", size);
      element.expect(size > 10 && !both ? rule : "").expect(size < 3 ? narrower : "");
    }
  }

  /** Plants keys shared by several elements, also of subclasses and in other files. */
  private void unique() {
    PlantedMetamodel.Type above = metamodel.type(BASE, true);
    PlantedMetamodel.Type of = metamodel.type(above, false);
    PlantedMetamodel.Type other = metamodel.type(above, false);
    metamodel.attribute(above, "key", "EInt", "");
    String all = above.inOcl() + ".allInstances()";
    boolean whole = random.nextBoolean();
    String text = whole ? all + "->isUnique(key)" : all + "->one(e | e.key = self.key)";
    String rule = metamodel.rule(above, text);
    List<Integer> keys = new ArrayList<>();
    for (int i = random.nextInt(5); i >= 0; i--) {
      keys.add(random.nextInt(5));
    }
    Set<Integer> known = new HashSet<>();
    Set<Integer> again = new HashSet<>();
    keys.forEach(key -> (known.add(key) ? known : again).add(key));
    for (int key : keys) {
      boolean violated = whole ? !again.isEmpty() : again.contains(key);
      element(random.nextBoolean() ? of : other).with("key", key).expect(violated ? rule : "");
    }
  }

  /** Plants nested parts that refer to their containers and to all their contents. */
  private void parts() {
    PlantedMetamodel.Type part = type();
    metamodel.attribute(part, "size", "EInt", "");
    metamodel.reference(
        part, "parts", part, MANY + CONTAINED + PlantedMetamodel.opposite(part, part, "whole"));
    metamodel.reference(part, "whole", part, PlantedMetamodel.opposite(part, part, "parts"));
    String smaller = metamodel.rule(part, "whole <> null implies size < whole.size");
    String type = part.inOcl();
    String kind = metamodel.rule(part, "eContainer().oclIsKindOf(" + type + ") = (whole <> null)");
    assert !kind.isEmpty(); // is never violated
    String few =
        metamodel.rule(part, "parts->asSet()->union(parts->closure(parts)->asSet())->size() < 4");
    PlantedElement whole = element(part).with("size", 9);
    PlantedElement at = whole;
    int size = 9;
    int depth = random.nextInt(6);
    for (int i = 0; i < depth; i++) {
      int below = size - 1 + random.nextInt(2);
      PlantedElement next = new PlantedElement(part).with("size", below);
      next.expect(below < size ? "" : smaller).expect(depth - i - 1 < 4 ? "" : few);
      at.part("parts", next);
      at = next;
      size = below;
    }
    whole.expect(depth < 4 ? "" : few);
  }

  private void literals() {
    PlantedMetamodel.Type context = type();
    metamodel.attribute(context, "one", COLOUR, "");
    metamodel.attribute(context, "some", COLOUR, MANY + "ordered=\"false\" ");
    String one = metamodel.rule(context, "one <> a::sub::Colour::GREEN");
    String some = metamodel.rule(context, "some->includes(one) or some->isEmpty()");
    PlantedMetamodel.Type of = below(context);
    element(of).with("one", "RED").value("some", "BLUE").value("some", "RED");
    element(of).with("one", "GREEN").expect(one);
    element(of).with("one", "BLUE").value("some", "GREEN").value("some", "RED").expect(some);
    element(of).value("some", "BLUE").expect(some); // RED is the default
  }
}
